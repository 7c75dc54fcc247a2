// A scan for the tests: a plate of 6 by 4 by 1 without its wall at x = 6, so that the surface ends there in borders; a bore of radius 0.7
// through it at (2, 2); and on its top beyond x = 3.8 shallow waves, folds of 28 degrees that a reader who looks for edges takes for
// false. Written by plate.mjs FILE.
import { writeFileSync } from "node:fs";

const PITCH = 0.04;
const [LENGTH, WIDTH, HEIGHT] = [6, 4, 1];
const [BORE, RADIUS] = [[2, 2], 0.7];
const WAVES = 3.8;

/** Numbers from 0 to 1, the same on every machine (minimal standard generator of Park and Miller). */
function random(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

/** Height of the waves of 0.8 from crest to crest, where there are some. */
function wave(x, y) {
  if (x < WAVES || x > LENGTH - 0.4 || y < 0.4 || y > WIDTH - 0.4) return 0;
  return 0.1 * Math.abs(((x - WAVES) / 0.4) % 2 - 1) - 0.1;
}

/** The scan as lines of x, y and z, with noise of a tenth of its pitch. */
function plate() {
  const next = random(7);
  const rows = [];
  const put = (...p) => rows.push(p.map((c) => (c + 0.2 * PITCH * (next() + next() + next() - 1.5)).toFixed(6)).join(" "));
  const spread = (a, b, act) => {
    for (let u = PITCH / 2; u < a; u += PITCH) for (let v = PITCH / 2; v < b; v += PITCH) act(u + PITCH * 0.4 * (next() - 0.5), v + PITCH * 0.4 * (next() - 0.5));
  };
  for (const z of [0, HEIGHT]) {
    spread(LENGTH, WIDTH, (x, y) => {
      if (Math.hypot(x - BORE[0], y - BORE[1]) > RADIUS) put(x, y, z + (z ? wave(x, y) : 0));
    });
  }
  spread(LENGTH, HEIGHT, (x, z) => [0, WIDTH].forEach((y) => put(x, y, z)));
  spread(WIDTH, HEIGHT, (y, z) => put(0, y, z));
  spread(2 * Math.PI * RADIUS, HEIGHT, (s, z) => put(BORE[0] + RADIUS * Math.cos(s / RADIUS), BORE[1] + RADIUS * Math.sin(s / RADIUS), z));
  return rows.join("\n") + "\n";
}

writeFileSync(process.argv[2], plate());
