/** Numbers as people type them: `3/4*2`, `2*pi`, `1.5e3`, `-(2+1)^2`. */

const FUNCTIONS: Record<string, (x: number) => number> = {
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  sqrt: Math.sqrt,
  abs: Math.abs,
  round: Math.round,
  floor: Math.floor,
  ceil: Math.ceil,
  ln: Math.log,
  log: Math.log10,
  exp: Math.exp,
  deg: (x) => (x * 180) / Math.PI,
  rad: (x) => (x * Math.PI) / 180,
};

const CONSTANTS: Record<string, number> = {
  pi: Math.PI,
  tau: 2 * Math.PI,
  e: Math.E,
  phi: (1 + Math.sqrt(5)) / 2,
};

/** Parentheses within parentheses, at most. */
const DEEPEST = 64;

/** The value of a formula; none when it is no formula or its value is not finite. `x` is what the field holds now. */
export function evaluate(text: string, x?: number): number | undefined {
  const tokens = text.toLowerCase().match(/\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|[a-z]+|[-+*/^%(),]|\S/g);
  if (!tokens) return undefined;
  const reader = new Reader(tokens, x);
  const value = reader.sum();
  return reader.done && value !== undefined && Number.isFinite(value) ? value : undefined;
}

/** Reads by precedence; each step gives nothing where the text does not fit. */
class Reader {
  #at = 0;
  #depth = 0;

  constructor(
    private readonly tokens: readonly string[],
    private readonly x: number | undefined,
  ) {}

  get done(): boolean {
    return this.#at === this.tokens.length;
  }

  sum(): number | undefined {
    let value = this.#product();
    for (let sign = this.#take("+", "-"); sign && value !== undefined; sign = this.#take("+", "-")) {
      const next = this.#product();
      value = next === undefined ? undefined : sign === "+" ? value + next : value - next;
    }
    return value;
  }

  #product(): number | undefined {
    let value = this.#signed();
    for (let sign = this.#take("*", "/", "%"); sign && value !== undefined; sign = this.#take("*", "/", "%")) {
      const next = this.#signed();
      if (next === undefined) return undefined;
      value = sign === "*" ? value * next : sign === "/" ? value / next : value % next;
    }
    return value;
  }

  /** The sign binds less than a power: −2^2 is −4. */
  #signed(): number | undefined {
    const sign = this.#take("-", "+");
    if (!sign) return this.#power();
    if (++this.#depth > DEEPEST) return undefined;
    const value = this.#signed();
    this.#depth--;
    return value === undefined ? undefined : sign === "-" ? -value : value;
  }

  #power(): number | undefined {
    const base = this.#atom();
    if (base === undefined || !this.#take("^")) return base;
    if (++this.#depth > DEEPEST) return undefined;
    const exponent = this.#signed();
    this.#depth--;
    return exponent === undefined ? undefined : base ** exponent;
  }

  #atom(): number | undefined {
    const token = this.tokens[this.#at++];
    if (token === undefined) return undefined;
    if (/^[\d.]/.test(token)) return Number(token);
    if (token === "(") return this.#closed();
    if (token === "x" && this.x !== undefined) return this.x;
    if (Object.hasOwn(CONSTANTS, token)) return CONSTANTS[token];
    const call = Object.hasOwn(FUNCTIONS, token) ? FUNCTIONS[token] : undefined;
    if (!call || !this.#take("(")) return undefined;
    const value = this.#closed();
    return value === undefined ? undefined : call(value);
  }

  #closed(): number | undefined {
    if (++this.#depth > DEEPEST) return undefined;
    const value = this.sum();
    this.#depth--;
    return this.#take(")") ? value : undefined;
  }

  #take(...which: string[]): string | undefined {
    const token = this.tokens[this.#at];
    if (token === undefined || !which.includes(token)) return undefined;
    this.#at++;
    return token;
  }
}
