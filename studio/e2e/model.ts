/** A Rhino model for tests, which Katydid writes itself. */
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const binary = process.env.KATYDID ?? "../target/release/katydid";

/** A beam along x from (0, 0, 0) to (10, 0, 0) on the layer Walls, and a ball of radius 3 about (0, 10, 0) on Site::Trees. */
const MODEL = `katydid 1

beam  = Line((0, 0, 0), (10, 0, 0)) hidden
walls = Model Object(beam, null, "beam", "Walls")
ball  = Sphere(plane((0, 10, 0)), 3) hidden
site  = Model Object(ball, null, "ball", "Site::Trees")
`;

/** The path of the model's file. */
export function writeModel(): string {
  const folder = mkdtempSync(join(tmpdir(), "katydid-model-"));
  const [definition, model] = [join(folder, "model.kd"), join(folder, "model.3dm")];
  writeFileSync(definition, MODEL);
  execFileSync(binary, ["run", definition, "-o", model]);
  return model;
}
