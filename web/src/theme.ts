// Colours of the picture in light and dark.

export interface Theme {
  background: number;
  surface: number;
  crease: number;
  border: number;
  rounded: number;
  slice: number;
  picked: number;
  node: Record<string, number>;
}

export const LIGHT: Theme = {
  background: 0xffffff, surface: 0xc9d0d8, crease: 0xcc3305, border: 0x005cb8, rounded: 0x8c4c9e, slice: 0x1a7f4b, picked: 0xd100a8,
  node: { junction: 0x14141a, corner: 0x008f6b, end: 0xd1529e, apex: 0xe69e00 },
};

export const DARK: Theme = {
  background: 0x14171c, surface: 0x6d7785, crease: 0xff7a45, border: 0x5aa9ff, rounded: 0xc79bdb, slice: 0x55d38a, picked: 0xff7be5,
  node: { junction: 0xf2f2f5, corner: 0x3fd6ab, end: 0xf08cc4, apex: 0xffc53d },
};

/** Of points by class: smooth, crease, border, corner, clutter. */
export const CLASSES: [string, number][] = [
  ["smooth", 0xc2c9d2], ["crease", 0xcc3305], ["border", 0x005cb8], ["corner", 0x008f6b], ["clutter", 0xb08900],
];

/** Of lines by confidence, from 0 to 1 in even steps: told apart by those who see no red or green, on light and on dark. */
const CONFIDENCE = { light: [0xb5179e, 0xe07b00, 0x00766c], dark: [0xff6ad5, 0xffb13d, 0x4fe0cf] };

export function confidence(share: number): number {
  const steps = CONFIDENCE[isDark() ? "dark" : "light"];
  const at = Math.min(1, Math.max(0, share)) * (steps.length - 1);
  const first = Math.min(steps.length - 2, Math.floor(at));
  const mix = (shift: number) => {
    const [a, b] = [steps[first], steps[first + 1]].map((c) => (c >> shift) & 255);
    return Math.round(a + (at - first) * (b - a)) << shift;
  };
  return mix(16) | mix(8) | mix(0);
}

/** A colour as CSS has it. */
export function css(colour: number): string {
  return `#${colour.toString(16).padStart(6, "0")}`;
}

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
