/** Predictions and exercises. */

import { button, make } from "./elements";
import { figureOf } from "./figure";
import { picked, related } from "./values";
import { word } from "./words";

interface Side {
  is: "answer" | "constant" | "value";
  value?: unknown;
  object?: string;
  output?: number;
  item?: number | null;
  axis?: number | null;
}

interface ExerciseData {
  figure: string;
  asks: boolean;
  checks: { left: Side; relation: string; right: Side; tolerance: number }[];
}

/** Makes the choices of a prediction buttons; the answer opens once one is taken. */
export function readyPredictions(): void {
  document.querySelectorAll(".predict").forEach((section, number) => {
    const details = section.querySelector("details");
    const choices = [...section.querySelectorAll<HTMLElement>(".choices > li")];
    for (const choice of choices) {
      const radio = make("input", { type: "radio", name: `predict-${number}` });
      choice.replaceChildren(make("label", {}, radio, " ", ...choice.childNodes));
      radio.addEventListener("change", () => {
        for (const other of choices) other.classList.remove("right", "wrong");
        const isRight = choice.dataset.right === "yes";
        choice.classList.add(isRight ? "right" : "wrong");
        choice.querySelector(".verdict")?.remove();
        choice.append(make("span", { class: "verdict", role: "status" }, ` ${word(isRight ? "right" : "wrong")}`));
        if (details) details.open = true;
      });
    }
  });
}

async function valueOf(side: Side, answer: number | undefined, figure: ReturnType<typeof figureOf>): Promise<unknown> {
  if (side.is === "constant") return side.value;
  if (side.is === "answer") return answer;
  const values = (await figure?.lesson?.values(side.object ?? "", side.output ?? 0)) ?? [];
  return picked(values, side.item ?? undefined, side.axis ?? undefined);
}

export function readyExercises(): void {
  for (const section of document.querySelectorAll<HTMLElement>(".exercise")) {
    const data = JSON.parse(section.querySelector("script")?.textContent ?? "{}") as ExerciseData;
    const field = make("input", { type: "text", inputmode: "decimal", size: 10 });
    const verdict = make("span", { role: "status", class: "verdict" });
    const check = button(word("check"), () => void tried());
    const tried = async () => {
      const figure = figureOf(data.figure);
      await figure?.start();
      const text = field.value.trim().replace("−", "-").replace(",", ".");
      const answer = data.asks && text !== "" ? Number(text) : undefined;
      const held = await Promise.all(
        data.checks.map(async ({ left, relation, right, tolerance }) =>
          related(await valueOf(left, answer, figure), relation, await valueOf(right, answer, figure), tolerance),
        ),
      );
      const isRight = held.every(Boolean);
      section.classList.toggle("solved", isRight);
      verdict.textContent = ` ${word(isRight ? "right" : "wrong")}`;
    };
    const row = make("p", { class: "check" });
    if (data.asks) row.append(make("label", {}, `${word("your-answer")} `, field), " ");
    row.append(check, verdict);
    section.querySelector("p")?.after(row);
  }
}
