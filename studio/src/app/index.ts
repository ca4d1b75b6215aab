export * from "./files";
export * from "./place";
