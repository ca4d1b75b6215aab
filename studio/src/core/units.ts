/** The short forms of the model's units. */

const SHORT: Record<string, string> = {
  Microns: "µm", Millimeters: "mm", Centimeters: "cm", Meters: "m", Kilometers: "km",
  Inches: "in", Feet: "ft", Yards: "yd", Miles: "mi",
};

/** Of a unit in Rhino's words; empty where there is none. */
export function unitOf(units: string | undefined): string {
  return (units && SHORT[units]) ?? "";
}

/** A unit to a power, with its space: ` mm`, ` 1/mm`, ` 1/mm²`; empty without a unit. */
export function unitSuffix(units: string | undefined, power: 1 | -1 | -2): string {
  const unit = unitOf(units);
  if (unit === "") return "";
  return power === 1 ? ` ${unit}` : ` 1/${unit}${power === -2 ? "²" : ""}`;
}
