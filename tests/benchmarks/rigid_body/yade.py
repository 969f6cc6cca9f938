# SPDX-License-Identifier: GPL-3.0-or-later
"""The pack of floes in Yade: PACK=... yade -f0 -n -x yade.py, $PACK naming a file of `bench_rigid_bodies pack`.

Explicit steps of polyhedra whose contacts press by the volume of their overlap. $DT is the step [s], $STIFFNESS twice
the pressure for a metre of overlap [Pa/m], $DAMPING Yade's local damping. Prints one JSON object as the others do.
"""
import itertools
import json
import math
import os
import time

from yade import polyhedra_utils

with open(os.environ["PACK"]) as file:
    pack = json.load(file)
dt, stiffness, damping = (float(os.environ[name]) for name in ("DT", "STIFFNESS", "DAMPING"))
# Stiffness along a contact, over that across it: at a tenth of this the floes creep 12 mm apart across the pack in 3 s,
# without friction 31 mm. (Yade's law keeps one friction force for all contacts.)
SHEAR = 0.5
NEAR = 0.01  # boxes are sorted with this to spare [m]


def material(friction):
    angle = math.atan(friction)
    return O.materials.append(PolyhedraMat(density=1.0, young=stiffness, poisson=SHEAR, frictionAngle=angle))


def add_floe(floe, ice):
    corners = itertools.product(*((-0.5 * size, 0.5 * size) for size in floe["size"]))
    body = polyhedra_utils.polyhedra(O.materials[ice], v=list(corners))
    body.state.inertia *= floe["mass"] / body.state.mass
    body.state.mass = floe["mass"]
    body.state.pos = Vector3(floe["start"])
    return O.bodies.append(body)


def fixed(axis):
    return O.bodies.append(utils.wall(0, axis=axis, sense=1, material=O.materials[slick]))


def measure():
    """Errors of both forces in this step."""
    for name, body, axis, force in (("bed", bed, 2, weight), ("wall", wall, 0, pack["push"] * weight)):
        errors[name].append(abs(-O.forces.f(body)[axis] / force - 1))


ice, slick = material(pack["friction"]), material(0.0)
floes = [add_floe(floe, ice) for floe in pack["floes"]]
bed, wall = fixed(2), fixed(0)
weight = pack["gravity"] * sum(floe["mass"] for floe in pack["floes"])
errors = {"bed": [], "wall": []}
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Polyhedra_Aabb(), Bo1_Wall_Aabb()], verletDist=NEAR),
    InteractionLoop([Ig2_Wall_Polyhedra_PolyhedraGeom(), Ig2_Polyhedra_Polyhedra_PolyhedraGeom()],
                    [Ip2_PolyhedraMat_PolyhedraMat_PolyhedraPhys()], [Law2_PolyhedraGeom_PolyhedraPhys_Volumetric()]),
    NewtonIntegrator(damping=damping, gravity=(-pack["push"] * pack["gravity"], 0, -pack["gravity"])),
]
O.dt = dt
measured = round(pack["measured"] / dt)
start = time.process_time()
O.run(round(pack["seconds"] / dt) - measured, wait=True)
O.engines = O.engines + [PyRunner(command="measure()", iterPeriod=1)]
O.run(measured, wait=True)
seconds = (time.process_time() - start) / pack["seconds"]
place = max((O.bodies[body].state.pos - Vector3(floe["rest"])).norm()
            for body, floe in zip(floes, pack["floes"], strict=True))
print(json.dumps({"floes": len(floes), "seconds": seconds, "position": place,
                  **{name: sum(values) / measured for name, values in errors.items()}}))
