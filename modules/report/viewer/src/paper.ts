// SPDX-License-Identifier: GPL-3.0-or-later
// The page on paper: in light, and with pictures that are drawn for the width that they have there.

/** Width of the text on A4, as the style has its margins. Letter is 6 mm wider, to which pictures stretch. */
const kWidth = "182mm";

/** What hears of it: pictures that depend on their width, and forms. */
const kListeners = ".plan, .stage, .form";

let onPaper = false;

/** Whether pictures are drawn for print now. */
export const isOnPaper = (): boolean => onPaper;

/** Pixels of a chart's canvas for each pixel of the page. A printer has more than a screen. */
export const fineness = (): number => (onPaper ? 3 : 1);

/** Calls `fit` with the element laid out as on paper before each print, and as on screen after it. */
export function onRefit(element: Element, fit: () => void): void {
  element.addEventListener("refit", fit);
}

function refit(): void {
  for (const each of document.querySelectorAll(kListeners)) each.dispatchEvent(new Event("refit"));
}

/** Calls `act` while the page is laid out as on paper. A browser reports a print before it lays the page out for it. */
function laidOutForPaper(act: () => void): void {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule): rule is CSSMediaRule => rule instanceof CSSMediaRule && rule.media.mediaText === "print");
  for (const { media } of rules) media.mediaText = "all";
  document.body.style.width = kWidth;
  try {
    act();
  } finally {
    document.body.style.width = "";
    for (const { media } of rules) media.mediaText = "print";
  }
}

/** Paper is white, whatever the screen is. @param retheme draws charts again, in the page's colours. */
export function preparePrints(retheme: () => void): void {
  const root = document.documentElement;
  let chosen: string | undefined;
  addEventListener("beforeprint", () => {
    if (onPaper) return;
    chosen = root.dataset.theme;
    root.dataset.theme = "light";
    onPaper = true;
    laidOutForPaper(() => {
      retheme();
      refit();
    });
  });
  addEventListener("afterprint", () => {
    onPaper = false;
    root.dataset.theme = chosen ?? "auto";
    retheme();
    refit();
  });
}
