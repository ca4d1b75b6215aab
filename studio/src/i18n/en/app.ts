export const app = {
  "app.title": "Katydid",
  "line.joining": "Joining Katydid …",
  "line.lost": "The connection is lost: trying again. Nothing is lost; edits wait until it is back.",
} as const;
