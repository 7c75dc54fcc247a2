// Colours of the picture in light and dark.

export interface Theme {
  background: number;
  surface: number;
  crease: number;
  border: number;
  slice: number;
  picked: number;
  node: Record<string, number>;
}

export const LIGHT: Theme = {
  background: 0xffffff, surface: 0xc9d0d8, crease: 0xcc3305, border: 0x005cb8, slice: 0x1a7f4b, picked: 0xd100a8,
  node: { junction: 0x14141a, corner: 0x008f6b, end: 0xd1529e, apex: 0xe69e00 },
};

export const DARK: Theme = {
  background: 0x14171c, surface: 0x6d7785, crease: 0xff7a45, border: 0x5aa9ff, slice: 0x55d38a, picked: 0xff7be5,
  node: { junction: 0xf2f2f5, corner: 0x3fd6ab, end: 0xf08cc4, apex: 0xffc53d },
};

/** Of points by class: smooth, crease, border, corner, clutter. */
export const CLASSES: [string, number][] = [
  ["smooth", 0xc2c9d2], ["crease", 0xcc3305], ["border", 0x005cb8], ["corner", 0x008f6b], ["clutter", 0xb08900],
];

const dark = window.matchMedia("(prefers-color-scheme: dark)");
let chosen: "light" | "dark" | null = null;

export function theme(): Theme {
  return isDark() ? DARK : LIGHT;
}

export function isDark(): boolean {
  return chosen ? chosen === "dark" : dark.matches;
}

export function toggle(): void {
  chosen = isDark() ? "light" : "dark";
  document.documentElement.dataset.theme = chosen;
}

export function onSystemChange(act: () => void): void {
  dark.addEventListener("change", act);
}
