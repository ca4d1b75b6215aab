export function ViewportPane() {
  return null;
}
