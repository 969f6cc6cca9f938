# SPDX-License-Identifier: GPL-3.0-or-later
"""Units against the rules of the standard: descriptions, order of calls, errors, logs.

References: FMI 2.0.4 and FMI 3.0.2 (Modelica Association, 2022 and 2024).
"""
import ctypes
import os
import pathlib
import subprocess
import tempfile
import unittest
import zipfile

from units import (CASE, Common, DISCARD, DRIVEN, ERROR, INPUTS, LOADS, OUTPUTS, STEP, UNITS, Under2, Under3, Unit,
                   brash, rows, sets, started)


class Tests(Common):
    def test_the_archive_holds_what_the_standard_asks_for(self):
        with zipfile.ZipFile(UNITS.file(self.fmi)) as archive:
            names = archive.namelist()
            self.assertIsNone(archive.testzip())
        self.assertEqual(names[0], "modelDescription.xml")
        self.assertIn(f"binaries/{'linux64' if self.fmi == 2 else 'x86_64-linux'}/brash.so", names)
        self.assertIn("resources/unit.json", names)
        self.assertIn("documentation/externalDependencies.txt", names)
        self.assertEqual(len(names), len(set(names)))

    def test_equal_cases_give_equal_units(self):
        again = UNITS.folder / f"again{self.fmi}.fmu"
        self.assertEqual(brash("export", "fmu", CASE, "-o", again, "--fmi", self.fmi,
                               *sets({"output.statistics_from": 0})).returncode, 0)
        self.assertEqual(again.read_bytes(), pathlib.Path(UNITS.file(self.fmi)).read_bytes())

    def test_names_references_causality_and_variability_keep_the_rules(self):
        variables = list(self.unit().description.find("ModelVariables"))
        names = [v.get("name") for v in variables]
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual([int(v.get("valueReference")) for v in variables], list(range(len(variables))))
        allowed = {("independent", "continuous", None), ("output", "continuous", "calculated"),
                   ("parameter", "fixed", "exact")}
        for v in variables:
            self.assertIn((v.get("causality"), v.get("variability"), v.get("initial")), allowed)
            self.assertTrue(v.get("description"))
        self.assertEqual([v.get("causality") for v in variables].count("independent"), 1)
        self.assertEqual([v.get("name") for v in variables if v.get("causality") == "output"], OUTPUTS)

    def test_parameters_have_start_bounds_and_a_defined_unit(self):
        description = self.unit().description
        units = {u.get("name"): {k: int(v) for k, v in u.find("BaseUnit").attrib.items()}
                 for u in description.iter("Unit")}
        self.assertEqual(units["Pa"], {"kg": 1, "m": -1, "s": -2})
        self.assertEqual(units["N m"], {"kg": 1, "m": 2, "s": -2})
        values = {v.get("name"): self.value_element(v) for v in description.find("ModelVariables")}
        strength = values["ice.flexural_strength"]
        self.assertEqual((float(strength.get("start")), strength.get("unit")), (539e3, "Pa"))
        self.assertEqual(values["random.seed"].get("start"), "1")
        for name, value in values.items():
            self.assertIn(value.get("unit", "Pa"), units, name)
            if name.split(".")[0] in ("ice", "structure", "random"):
                least, most = value.get("min"), value.get("max")
                self.assertLessEqual(float(least), float(value.get("start")), name)
                self.assertLessEqual(float(value.get("start")), float(most or "inf"), name)
            else:
                self.assertIsNone(value.get("start"), name)

    def test_a_parameter_out_of_its_range_is_discarded_and_keeps_its_value(self):
        instance = self.keep(self.unit().instantiate())
        for value in (-1.0, 0.5, float("nan"), float("inf")):
            self.refuses(DISCARD, instance.set, {"ice.poisson_ratio": value})
        self.refuses(DISCARD, instance.set, {"random.seed": -1}, whole=True)
        self.assertEqual(instance.get(["ice.poisson_ratio"]), [0.3])
        instance.enter_initialization()

    def test_values_of_a_call_are_set_all_or_none(self):
        instance = self.keep(self.unit().instantiate())
        names = ["ice.youngs_modulus", "ice.poisson_ratio"]
        before = instance.get(names)
        self.refuses(DISCARD, instance.set, dict(zip(names, (1e9, 5.0))))
        self.assertEqual(instance.get(names), before)
        instance.set(dict(zip(names, (1e9, 0.25))))
        self.assertEqual(instance.get(names), [1e9, 0.25])
        driven = self.keep(started(self.unit(**DRIVEN)))
        self.refuses(DISCARD, driven.set, {"structure_y": 1.0, "structure_vx": float("nan")})
        self.assertEqual(driven.get(["structure_y"]), [0.0])
        self.refuses(DISCARD, driven.set, {"structure_yaw": 1e9})

    def test_a_structure_that_turns_over_in_a_step_is_refused(self):
        driven = self.keep(started(self.unit(**DRIVEN)))
        driven.set({"structure_pitch": 3.1})
        self.refuses(ERROR, driven.step, 0.0, STEP)

    def test_a_step_beyond_the_end_of_the_path_is_discarded(self):
        instance = self.keep(self.unit(case=self.path_case()).instantiate())
        instance.enter_initialization(start=10.0)
        instance.exit_initialization()
        instance.step(10.0, 0.98)
        refused = self.refuses(DISCARD, instance.step, 10.98, 3 * STEP)
        self.assertIn("the path at 11 s", str(refused))
        instance.step(10.98, 2 * STEP)
        self.refuses(DISCARD, instance.step, 11.0, STEP)

    def test_what_cannot_be_set_or_read_is_an_error(self):
        for attempt in (lambda i: i.set({"Fx": 1.0}), lambda i: i.set({"time": 1.0}), lambda i: i.set({9999: 1.0}),
                        lambda i: i.set({"random.seed": 1.0}), lambda i: i.set({"ice.poisson_ratio": 1}, whole=True),
                        lambda i: i.get([9999]), lambda i: i.get(["random.seed"]), lambda i: i.get(["Fx"], whole=True)):
            instance = self.keep(self.unit().instantiate())
            self.refuses(ERROR, attempt, instance)
            self.assertEqual(instance.categories[-1], "logStatusError")

    def test_damaged_and_foreign_bytes_are_refused(self):
        instance = self.keep(started(self.unit()))
        data = instance.serialize(instance.get_state())
        foreign = self.keep(started(self.unit(**{"ice.thickness": 0.4})))
        for damaged in (b"", data[:100], data[:-1], data[:200] + b"x" + data[201:],
                        foreign.serialize(foreign.get_state())):
            reader = self.keep(self.unit().instantiate())
            self.refuses(ERROR, reader.deserialize, damaged)

    def test_calls_out_of_order_are_errors_and_reset_brings_the_instance_back(self):
        instance = self.keep(self.unit().instantiate())
        for wrong in (lambda: instance.step(0.0, STEP), instance.exit_initialization, instance.terminate):
            self.refuses(ERROR, wrong)
            self.refuses(ERROR, instance.enter_initialization)  # an error ends it
            instance.reset()
        instance.enter_initialization()
        self.refuses(ERROR, instance.enter_initialization)
        instance.reset()
        instance.enter_initialization()
        instance.exit_initialization()
        self.refuses(ERROR, instance.set, {"ice.flexural_strength": 4e5})
        instance.reset()
        instance.enter_initialization()
        instance.exit_initialization()
        history = UNITS.history(3)
        self.assertEqual(rows(instance, 0, 40), history[:40])
        instance.terminate()
        self.assertEqual(instance.get(OUTPUTS), history[39])
        self.refuses(ERROR, instance.step, 40 * STEP, STEP)

    def test_a_step_that_is_none_is_discarded_and_another_goes_on(self):
        instance = self.keep(self.unit().instantiate())
        instance.enter_initialization(stop=1.0)
        instance.exit_initialization()
        for at, size in ((0.0, 0.0), (0.0, -STEP), (0.0, float("nan")), (0.0, float("inf")), (STEP, STEP)):
            self.refuses(DISCARD, instance.step, at, size)
        self.assertEqual(instance.categories[-1], "logStatusDiscard")
        instance.step(0.0, STEP * (1 + 1e-9))
        self.assertEqual(instance.get(["time"]), [STEP])

    def test_a_host_reaches_the_stop_time_by_steps_that_are_no_multiples(self):
        instance = self.keep(self.unit().instantiate())
        instance.enter_initialization(start=5.0, stop=5.1)
        instance.exit_initialization()
        for i, part in enumerate((0.5, 1.0, 3.3, 0.1, 0.1, 4.0)):
            instance.step(instance.get(["time"])[0], part * STEP)
        instance.step(instance.get(["time"])[0], 5.1 - instance.get(["time"])[0])
        self.assertAlmostEqual(instance.get(["time"])[0], 5.1, delta=1e-12)
        self.assertEqual(instance.messages, [])
        instance.terminate()

    def test_a_step_past_the_stop_time_is_an_error(self):
        instance = self.keep(self.unit().instantiate())
        instance.enter_initialization(stop=3 * STEP)
        instance.exit_initialization()
        instance.step(0.0, 3 * STEP)
        refused = self.refuses(ERROR, instance.step, 3 * STEP, STEP)
        self.assertIn("beyond the stop time 0.03 s", str(refused))
        self.assertEqual(instance.categories[-1], "logStatusError")

    def test_an_instance_needs_its_name_token_and_resources(self):
        for wrong in ({"name": " "}, {"token": "other"}, {"resources": "/nowhere"}):
            instance = self.unit().instantiate(**wrong)
            self.assertIsNone(instance.pointer.value)
            self.assertEqual(instance.categories, ["logStatusError"])

    def test_a_damaged_case_in_the_resources_is_refused_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            unit = Unit(UNITS.file(self.fmi), folder)
            path = unit.folder / "resources/unit.json"
            text = path.read_text(encoding="utf-8")
            for damaged in ("", text[:500], text.replace("brash-fmu-1", "brash-fmu-0"), text.replace('"cone"', '"cube"'),
                            text.replace('"thickness"', '"thicknes"')):
                path.write_text(damaged, encoding="utf-8")
                instance = unit.instantiate()
                self.assertIsNone(instance.pointer.value)
                self.assertIn("unit.json", instance.messages[-1])

    def test_an_export_does_not_take_the_place_of_its_case(self):
        case = UNITS.folder / f"own{self.fmi}.toml"
        case.write_bytes(CASE.read_bytes())
        self.assertEqual(brash("export", "fmu", case, "-o", case, "--fmi", self.fmi).returncode, 2)
        self.assertEqual(case.read_bytes(), CASE.read_bytes())

    def test_a_case_whose_name_no_description_can_hold_is_refused(self):
        for name in (b"c\xff.toml", b"c\x01.toml"):
            case, unit = bytes(UNITS.folder) + b"/" + name, UNITS.folder / f"named{self.fmi}.fmu"
            pathlib.Path(os.fsdecode(case)).write_bytes(CASE.read_bytes())
            said = brash("export", "fmu", os.fsdecode(case), "-o", unit, "--fmi", self.fmi)
            self.assertEqual(said.returncode, 2, said.stderr)
            self.assertIn("rename the file", said.stderr)
            self.assertFalse(unit.exists())

    def test_errors_are_logged_even_where_the_log_is_off_and_discards_are_not(self):
        instance = self.keep(self.unit().instantiate(logging=False))
        self.refuses(DISCARD, instance.set, {"ice.poisson_ratio": 9.0})
        self.assertEqual(instance.messages, [])
        instance.call("SetDebugLogging", self.flag(True), ctypes.c_size_t(1), (ctypes.c_char_p * 1)(b"logStatusDiscard"))
        self.refuses(DISCARD, instance.set, {"ice.poisson_ratio": 9.0})
        self.assertIn("ice.poisson_ratio = 9", instance.messages[-1])
        self.refuses(ERROR, instance.terminate)
        self.assertEqual(instance.categories[-1], "logStatusError")

    def test_a_null_pointer_in_place_of_a_category_is_an_error(self):
        instance = self.keep(self.unit().instantiate())
        for categories in (None, (ctypes.c_char_p * 1)(None)):
            refused = self.refuses(ERROR, instance.call, "SetDebugLogging", self.flag(True), ctypes.c_size_t(1), categories)
            self.assertIn("null pointer", str(refused))
            instance.reset()

    def test_a_driven_unit_has_inputs_with_a_start_at_rest(self):
        variables = {v.get("name"): v for v in self.unit(**DRIVEN).description.find("ModelVariables")}
        self.assertEqual([n for n, v in variables.items() if v.get("causality") == "input"], INPUTS)
        self.assertEqual([n for n, v in variables.items() if v.get("causality") == "output"], LOADS)
        self.assertNotIn("structure.speed", variables)
        for name in INPUTS:
            self.assertEqual(variables[name].get("variability"), "continuous")
            self.assertIsNone(variables[name].get("initial"))
            start = float(self.value_element(variables[name]).get("start"))
            self.assertEqual(start, -7.0 if name == "structure_x" else 0.0)

    def test_an_input_that_is_not_finite_is_discarded(self):
        instance = self.keep(started(self.unit(**DRIVEN)))
        for value in (float("nan"), float("inf")):
            self.refuses(DISCARD, instance.set, {"structure_x": value})
        self.assertEqual(instance.get(["structure_x"]), [-7.0])

    def test_the_library_needs_no_library_of_files(self):
        linked = subprocess.run(["ldd", self.unit().library_file], capture_output=True, text=True, check=True).stdout
        for library in ("netcdf", "hdf5", "udunits", "ssl", "crypto", "minizip"):
            self.assertNotIn(library, linked)
        self.assertNotIn("not found", linked)

    def test_every_library_but_those_of_c_and_cpp_is_in_the_unit(self):
        folder = self.unit().library_file.parent
        linked = subprocess.run(["ldd", self.unit().library_file], capture_output=True, text=True, check=True).stdout
        for name, path in [(line.split()[0], pathlib.Path(line.split()[2])) for line in linked.splitlines() if "=>" in line]:
            if name not in ("libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1"):
                self.assertEqual(path, folder / name)
        told = (self.unit().folder / "documentation/externalDependencies.txt").read_text(encoding="ascii")
        self.assertRegex(told, r"glibc 2\.[0-9]+ or newer")


class Fmi2(Under2, Tests, unittest.TestCase):
    def test_the_description_has_the_elements_in_the_order_of_the_schema(self):
        root = self.unit().description
        self.assertEqual(root.tag, "fmiModelDescription")
        self.assertEqual(root.get("fmiVersion"), "2.0")
        self.assertEqual([element.tag for element in root], ["CoSimulation", "UnitDefinitions", "LogCategories",
                                                             "DefaultExperiment", "ModelVariables", "ModelStructure"])
        abilities = root.find("CoSimulation")
        for ability in ("canHandleVariableCommunicationStepSize", "canGetAndSetFMUstate", "canSerializeFMUstate"):
            self.assertEqual(abilities.get(ability), "true")
        self.assertEqual(root.find("DefaultExperiment").get("stepSize"), "0.01")

    def test_the_structure_lists_every_output_by_its_index(self):
        root = self.unit().description
        indices = [str(1 + self.unit().references[name]) for name in OUTPUTS]
        for part in ("Outputs", "InitialUnknowns"):
            self.assertEqual([u.get("index") for u in root.find("ModelStructure").find(part)], indices)

    def test_the_library_has_the_functions_of_co_simulation(self):
        library = self.unit().library
        for function in ("GetTypesPlatform", "GetVersion"):
            getattr(library, "fmi2" + function).restype = ctypes.c_char_p
        self.assertEqual(library.fmi2GetTypesPlatform(), b"default")
        self.assertEqual(library.fmi2GetVersion(), b"2.0")
        for name in ("GetBoolean", "SetBoolean", "GetString", "SetString", "CancelStep", "GetStatus", "GetRealStatus",
                     "GetIntegerStatus", "GetBooleanStatus", "GetStringStatus", "GetDirectionalDerivative",
                     "SetRealInputDerivatives", "GetRealOutputDerivatives"):
            self.assertTrue(hasattr(library, "fmi2" + name))

    def test_the_place_of_resources_is_any_uri_of_a_file(self):
        place = (self.unit().folder / "resources").as_uri().removeprefix("file://")
        for uri in (f"file:{place}", f"file://localhost{place}", f"FILE://{place}", f"File://{place}?version=2#top",
                    f"file://{place.replace('r', '%72')}#"):
            with self.subTest(uri):
                self.assertIsNotNone(self.keep(self.unit().instantiate(resources=uri)).pointer.value)

    def test_model_exchange_is_refused(self):
        self.assertIsNone(self.unit().instantiate(kind=0).pointer.value)

    def test_the_last_successful_time_is_told(self):
        instance = self.keep(started(self.unit()))
        instance.step(0.0, 3 * STEP)
        self.refuses(DISCARD, instance.step, 3 * STEP, -STEP)
        time = ctypes.c_double()
        instance.call("GetRealStatus", 2, ctypes.byref(time))
        self.assertEqual(time.value, 3 * STEP)
        instance.step(3 * STEP, 0.3 * STEP)
        instance.call("GetRealStatus", 2, ctypes.byref(time))
        self.assertAlmostEqual(time.value, 3.3 * STEP, delta=1e-12)
        self.refuses(DISCARD, instance.call, "GetStatus", 0, ctypes.byref(ctypes.c_int()))

    def test_a_seed_beyond_the_integers_is_refused_with_the_remedy(self):
        said = brash("export", "fmu", CASE, "-o", UNITS.folder / "big.fmu", "--set", "random.seed=3000000000")
        self.assertEqual(said.returncode, 2)
        self.assertIn("--fmi 3", said.stderr)
        self.assertFalse((UNITS.folder / "big.fmu").exists())


class Fmi3(Under3, Tests, unittest.TestCase):
    def test_the_description_has_the_elements_in_the_order_of_the_schema(self):
        root = self.unit().description
        self.assertEqual(root.tag, "fmiModelDescription")
        self.assertEqual(root.get("fmiVersion"), "3.0")
        self.assertEqual([element.tag for element in root], ["CoSimulation", "UnitDefinitions", "LogCategories",
                                                             "DefaultExperiment", "ModelVariables", "ModelStructure"])
        abilities = root.find("CoSimulation")
        for ability in ("canHandleVariableCommunicationStepSize", "canGetAndSetFMUState", "canSerializeFMUState"):
            self.assertEqual(abilities.get(ability), "true")
        self.assertEqual(abilities.get("fixedInternalStepSize"), "0.01")

    def test_the_structure_lists_every_output_by_its_reference(self):
        root = self.unit().description
        references = [str(self.unit().references[name]) for name in OUTPUTS]
        structure = root.find("ModelStructure")
        self.assertEqual([u.get("valueReference") for u in structure.findall("Output")], references)
        self.assertEqual([u.get("valueReference") for u in structure.findall("InitialUnknown")], references)

    def test_the_library_has_every_function_of_the_standard(self):
        library = self.unit().library
        library.fmi3GetVersion.restype = ctypes.c_char_p
        self.assertEqual(library.fmi3GetVersion(), b"3.0")
        types = ("Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
                 "Boolean", "String", "Binary", "Clock")
        names = [access + of for of in types for access in ("Get", "Set")] + """
            SetDebugLogging InstantiateModelExchange InstantiateCoSimulation InstantiateScheduledExecution FreeInstance
            EnterInitializationMode ExitInitializationMode EnterEventMode Terminate Reset
            GetNumberOfVariableDependencies GetVariableDependencies GetFMUState SetFMUState FreeFMUState
            SerializedFMUStateSize SerializeFMUState DeserializeFMUState GetDirectionalDerivative GetAdjointDerivative
            EnterConfigurationMode ExitConfigurationMode GetIntervalDecimal GetIntervalFraction GetShiftDecimal
            GetShiftFraction SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction
            EvaluateDiscreteStates UpdateDiscreteStates EnterContinuousTimeMode CompletedIntegratorStep SetTime
            SetContinuousStates GetContinuousStateDerivatives GetEventIndicators GetContinuousStates
            GetNominalsOfContinuousStates GetNumberOfEventIndicators GetNumberOfContinuousStates EnterStepMode
            GetOutputDerivatives DoStep ActivateModelPartition""".split()
        for name in names:
            self.assertTrue(hasattr(library, "fmi3" + name), name)

    def test_other_kinds_of_instance_and_event_mode_are_refused(self):
        self.assertIsNone(self.unit().instantiate(event_mode=True).pointer.value)
        instantiate = self.unit().library.fmi3InstantiateModelExchange
        instantiate.restype = ctypes.c_void_p
        self.assertIsNone(instantiate(b"name", self.unit().token.encode(), b"/", False, False, None, None))

    def test_abilities_that_the_unit_does_not_have_are_errors(self):
        for call in ("EnterEventMode", "EnterStepMode", "EnterConfigurationMode", "EvaluateDiscreteStates"):
            self.refuses(ERROR, self.keep(started(self.unit())).call, call)
        instance = self.keep(started(self.unit()))
        instance.call("GetFloat32", None, ctypes.c_size_t(0), None, ctypes.c_size_t(0))
        self.refuses(ERROR, instance.call, "GetFloat32", (ctypes.c_uint * 1)(0), ctypes.c_size_t(1),
                     (ctypes.c_float * 1)(), ctypes.c_size_t(1))

    def test_the_number_of_values_must_be_that_of_the_references(self):
        instance = self.keep(self.unit().instantiate())
        self.refuses(ERROR, instance.call, "GetFloat64", (ctypes.c_uint * 1)(0), ctypes.c_size_t(1),
                     (ctypes.c_double * 2)(), ctypes.c_size_t(2))

    def test_the_time_reached_is_told(self):
        instance = self.keep(started(self.unit()))
        instance.step(0.0, 3 * STEP)
        self.assertEqual(instance.reached, 3 * STEP)

    def test_a_seed_beyond_32_bits_is_a_parameter(self):
        seed = 3_000_000_000
        instance = self.keep(started(self.unit(**{"random.seed": seed})))
        self.assertEqual(instance.get(["random.seed"], whole=True), [seed])


if __name__ == "__main__":
    unittest.main()
