// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run with its replay at the size of a picture: for stills and the film.
// The page's packages are those of the build (BRASH_PACKAGES, default build/release/modules/report/viewer).
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
export const { browse, saved } = await import(join(root, "tests/modules/report/browser.mjs"));

/** Lets a browser's pages draw as with a graphics card, whatever draws: with smooth lines. For pages opened afterwards. */
export const smoothed = (browser) => browser.context.addInitScript(() => {
  const ask = WebGL2RenderingContext.prototype.getExtension;
  WebGL2RenderingContext.prototype.getExtension = function (name) {
    return name === "WEBGL_debug_renderer_info" ? null : ask.call(this, name);
  };
});

/** Gives the replay alone the size of a picture [px]. */
export async function sized(page, width, height) {
  await page.addStyleTag({
    content: `.stage { position: fixed !important; inset: 0 auto auto 0; z-index: 9; width: ${width}px; height: ${height}px !important; max-height: none; border: 0; border-radius: 0; } .legend { display: none !important; }`,
  });
  // It would follow that size once the page is drawn anew.
  await page.evaluate(([w, h]) => window.brashReport.report.replay.scene.resize(w, h), [width, height]);
}

/** Stands the camera where the middle of the run is seen best, and lets the structure pass; or looks at the end, as `view`. */
export const look = (page, view) => page.evaluate((name) => {
  const { player, replay: { scene } } = window.brashReport.report;
  scene.follow = false;
  player.seek((name === "Wake" ? 0.42 : 1) * player.duration);
  scene.look(name);
  if (name === "Wake") scene.camera.position.sub(scene.controls.target).multiplyScalar(1.15).add(scene.controls.target);
}, view);
