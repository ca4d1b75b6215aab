import { describe, expect, test } from "vitest";

import { IDLE, step, type Button, type Effect, type Gesture, type State, type Target, type World } from "../../src/canvas/gestures/chart";
import type { Point } from "../../src/core/geometry";
import type { Grip } from "../../src/core/hit";
import { NO_KEYS, type Keys } from "../../src/core/selection";

/** A hand on a canvas: it goes through gestures and keeps what came of them. */
class Hand {
  state: State = IDLE;
  effects: Effect[] = [];
  selected = new Set<string>();
  grips: Grip[] = [];
  keys: Keys = NO_KEYS;

  readonly world: World = {
    isSelected: (id) => this.selected.has(id),
    gripNear: (at, fits) => this.grips.find((grip) => Math.hypot(grip.at[0] - at[0], grip.at[1] - at[1]) < 10 && fits(grip)),
    companions: (grip) => (this.selected.has(grip.object) ? this.along : []),
  };
  along: Grip[] = [];

  take(gesture: Gesture): this {
    const [state, effects] = step(this.state, gesture, this.world);
    this.state = state;
    this.effects.push(...effects);
    return this;
  }

  down(at: Point, target: Target = { is: "void" }, button: Button = "left"): this {
    return this.take({ on: "down", button, target, at, pixel: at, keys: this.keys });
  }

  move(at: Point): this {
    return this.take({ on: "move", at, pixel: at, keys: this.keys });
  }

  up(at: Point, target: Target = { is: "void" }): this {
    return this.take({ on: "up", target, at, pixel: at, keys: this.keys });
  }

  with(keys: Partial<Keys>): this {
    this.keys = { ...NO_KEYS, ...keys };
    return this;
  }

  get done(): string[] {
    return this.effects.map((effect) => effect.do);
  }

  last<K extends Effect["do"]>(what: K): Extract<Effect, { do: K }> | undefined {
    return this.effects.findLast((effect): effect is Extract<Effect, { do: K }> => effect.do === what);
  }
}

const A: Target = { is: "object", id: "a", group: false };
const G: Target = { is: "object", id: "g", group: true };
const grip = (port: string, side: "input" | "output", at: Point, object = port): Grip => ({ port, side, at, object });

describe("clicks", () => {
  test("on an object select it, on nothing select nothing", () => {
    expect(new Hand().down([0, 0], A).up([1, 1], A).last("select")).toEqual({ do: "select", ids: ["a"], how: "replace" });
    expect(new Hand().down([0, 0]).up([1, 1]).last("select")?.ids).toEqual([]);
  });

  test("with Shift add and with Ctrl take away", () => {
    expect(new Hand().with({ shift: true }).down([0, 0], A).last("select")?.how).toBe("add");
    const hand = new Hand().with({ ctrl: true });
    hand.selected.add("a");
    expect(hand.down([0, 0], A).up([0, 0], A).last("select")?.how).toBe("remove");
  });

  test("with Shift on nothing leave the selection", () => {
    expect(new Hand().with({ shift: true }).down([0, 0]).up([0, 0]).last("select")).toBeUndefined();
  });

  test("on one of many selected objects keep all while it may be a drag, then select it alone", () => {
    const hand = new Hand();
    hand.selected = new Set(["a", "b"]);
    expect(hand.down([0, 0], A).done).toEqual([]);
    expect(hand.up([0, 0], A).last("select")).toEqual({ do: "select", ids: ["a"], how: "replace" });
  });
});

describe("windows", () => {
  test("to the right are whole, to the left cross", () => {
    expect(new Hand().down([0, 0]).move([50, 50]).up([60, 60]).last("take")).toMatchObject({ crossing: false, rect: [0, 0, 60, 60] });
    expect(new Hand().down([60, 0]).move([20, 50]).up([0, 60]).last("take")).toMatchObject({ crossing: true, rect: [0, 0, 60, 60] });
  });

  test("begin on a group with Shift; without it the group is dragged", () => {
    expect(new Hand().with({ shift: true }).down([0, 0], G).move([50, 50]).done).toContain("window");
    expect(new Hand().down([0, 0], G).move([50, 50]).done).toContain("drag");
  });

  test("are abandoned by Escape", () => {
    const hand = new Hand().down([0, 0]).move([50, 50]).take({ on: "cancel" });
    expect(hand.last("window")?.window).toBeUndefined();
    expect(hand.up([60, 60]).done).not.toContain("take");
  });
});

describe("drags", () => {
  test("begin after a few pixels, and tell how far from the press", () => {
    const hand = new Hand().down([10, 10], A).move([12, 11]);
    expect(hand.done).toEqual(["select"]);
    expect(hand.move([30, 40]).last("drag")?.by).toEqual([20, 30]);
    expect(hand.with({ alt: true }).up([40, 40]).last("drop")).toMatchObject({ by: [30, 30], keys: { alt: true } });
  });

  test("are abandoned by Escape", () => {
    expect(new Hand().down([10, 10], A).move([90, 90]).take({ on: "cancel" }).up([90, 90]).done).not.toContain("drop");
  });
});

test("a drag of which only the end is told is a drag", () => {
  expect(new Hand().down([10, 10], A).up([60, 60], A).last("drop")?.by).toEqual([50, 50]);
  expect(new Hand().down([0, 0], A, "right").up([60, 0], A).done).toEqual(["pan"]);
  expect(new Hand().down([0, 0]).up([60, 60]).done).toContain("take");
});

describe("the right button", () => {
  test("pans when it is dragged, opens the menu when it is not", () => {
    const hand = new Hand().down([0, 0], A, "right").move([10, 0]).move([15, 5]).up([15, 5], A);
    expect(hand.done).toEqual(["pan", "pan"]);
    expect(new Hand().down([0, 0], A, "right").move([1, 1]).up([1, 1], A).last("menu")?.target).toEqual(A);
  });

  test("loses no step of the way when it begins to pan", () => {
    const hand = new Hand().down([0, 0], A, "right").move([3, 0]).move([10, 0]).move([20, 0]);
    const way = hand.effects.map((effect) => (effect.do === "pan" ? effect.by[0] : 0)).reduce((a, b) => a + b, 0);
    expect(way).toBe(20);
  });
});

describe("wires", () => {
  const from = grip("o", "output", [0, 0]);
  const to = grip("i", "input", [100, 0]);
  const start = (keys: Partial<Keys> = {}) => {
    const hand = new Hand().with(keys);
    hand.grips = [from, to, grip("p", "output", [0, 50]), grip("own", "input", [100, 50], "o")];
    return hand.down([0, 0], { is: "grip", grip: from });
  };

  test.each<[Partial<Keys>, string]>([[{}, "replace"], [{ shift: true }, "add"], [{ ctrl: true }, "remove"]])(
    "with %j go to a grip of the other side",
    (keys, how) => {
      expect(start(keys).move([98, 2]).up([98, 2]).last("join")).toEqual({ do: "join", from, more: [], to, how });
    },
  );

  test("of a grip are taken to another of the same side with Ctrl and Shift", () => {
    const keys = { ctrl: true, shift: true };
    expect(start(keys).move([2, 48]).up([2, 48]).last("join")).toMatchObject({ how: "move", to: { port: "p" } });
    expect(start(keys).move([98, 2]).up([98, 2]).done).not.toContain("join");
  });

  test("snap to what they would take hold of", () => {
    expect(start().move([95, 4]).last("wire")?.wire?.to).toEqual([100, 0]);
    expect(start().move([60, 4]).last("wire")?.wire?.end).toBeUndefined();
  });

  test("do not go from an object to itself", () => {
    expect(start().move([100, 50]).up([100, 50]).done).not.toContain("join");
  });

  test("let go in the void ask for what takes them; over an object or close by they do not", () => {
    expect(start().move([60, 80]).up([60, 80]).last("release")?.grip).toEqual(from);
    expect(start().move([60, 80]).up([60, 80], A).done).not.toContain("release");
    expect(start().move([3, 3]).up([3, 3]).done).not.toContain("release");
    expect(start({ ctrl: true }).move([60, 80]).up([60, 80]).done).not.toContain("release");
  });
});

test("whatever comes, a gesture ends", () => {
  const targets: Target[] = [{ is: "void" }, A, G, { is: "wire", from: "o", to: "i" }, { is: "grip", grip: grip("o", "output", [0, 0]) }];
  let seed = 7;
  const random = (n: number) => (seed = (seed * 1103515245 + 12345) % 2147483648) % n;
  for (let run = 0; run < 300; run++) {
    const hand = new Hand();
    for (let k = 0; k < 12; k++) {
      const at: Point = [random(200), random(200)];
      const target = targets[random(targets.length)] ?? { is: "void" };
      hand.with({ shift: random(2) === 0, ctrl: random(2) === 0, alt: random(2) === 0 });
      const act = random(4);
      if (act === 0) hand.down(at, target, (["left", "pan", "right"] as const)[random(3)]);
      else if (act === 1) hand.up(at, target);
      else hand.move(at);
    }
    hand.take({ on: "cancel" });
    expect(hand.state).toEqual(IDLE);
    // Nothing that is only shown during a gesture stays.
    expect(hand.last("window")?.window).toBeUndefined();
    expect(hand.last("wire")?.wire).toBeUndefined();
  }
});

describe("the middle button", () => {
  test("opens the ring where it is clicked, and pans when it is dragged", () => {
    const hand = new Hand().down([5, 5], A, "middle").up([6, 6], A);
    expect(hand.last("radial")).toEqual({ do: "radial", target: A, pixel: [6, 6] });
    expect(hand.state).toEqual(IDLE);
    const dragged = new Hand().down([5, 5], A, "middle").move([25, 5]).up([25, 5]);
    expect(dragged.done).toEqual(["pan"]);
    expect(new Hand().down([5, 5], A, "middle").up([40, 5]).done).toEqual(["pan"]);
  });
});

describe("Alt on the empty canvas", () => {
  test("makes room from where it began, until it is let go or abandoned", () => {
    const hand = new Hand().with({ alt: true }).down([10, 10]).move([60, 12]);
    expect(hand.last("spread")).toEqual({ do: "spread", from: [10, 10], to: [60, 12], drop: false });
    hand.up([70, 12]);
    expect(hand.last("spread")).toEqual({ do: "spread", from: [10, 10], to: [70, 12], drop: true });
    const undone = new Hand().with({ alt: true }).down([10, 10]).move([60, 12]).take({ on: "cancel" });
    expect(undone.done.at(-1)).toBe("undrag");
  });
});

describe("several objects are wired at once", () => {
  const selected = () => {
    const hand = new Hand();
    hand.selected = new Set(["a", "b", "c"]);
    hand.along = [grip("b.out", "output", [0, 20], "b"), grip("c.out", "output", [0, 40], "c")];
    hand.grips = [grip("in", "input", [100, 0], "d"), grip("b.in", "input", [100, 50], "b")];
    return hand;
  };
  const start: Target = { is: "grip", grip: grip("a.out", "output", [0, 0], "a") };

  test.each([
    ["replace", {}],
    ["add", { shift: true }],
    ["remove", { ctrl: true }],
  ] as const)("what is selected goes along: %s", (how, keys) => {
    const hand = selected().with(keys).down([0, 0], start).move([60, 0]);
    expect(hand.last("wire")?.wire?.more).toHaveLength(2);
    hand.up([100, 0]);
    const join = hand.last("join");
    expect([join?.how, join?.to.port, join?.more.map(({ port }) => port)]).toEqual([how, "in", ["b.out", "c.out"]]);
  });

  test("to another of the selected goes one wire, and all wires of a grip are taken elsewhere alone", () => {
    const one = selected().down([0, 0], start).move([60, 50]).up([100, 50]).last("join");
    expect([one?.to.port, one?.more]).toEqual(["b.in", []]);
    const hand = selected();
    hand.grips.push(grip("e.out", "output", [100, 90], "e"));
    const moved = hand.with({ shift: true, ctrl: true }).down([0, 0], start).move([60, 90]).up([100, 90]).last("join");
    expect([moved?.how, moved?.more]).toEqual(["move", []]);
  });

  test("let go in the void they all wait for what is found", () => {
    expect(selected().down([0, 0], start).move([60, 300]).up([60, 300]).last("release")?.more).toHaveLength(2);
  });

  test("from what is not selected goes one wire", () => {
    const hand = selected();
    hand.selected.delete("a");
    expect(hand.down([0, 0], start).move([60, 0]).up([100, 0]).last("join")?.more).toEqual([]);
  });
});
