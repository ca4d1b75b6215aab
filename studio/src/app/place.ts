/** What the address of the page asks for. */

export interface Place {
  document: string | undefined;
  player: boolean;
}

export function place(search: string): Place {
  const query = new URLSearchParams(search);
  return { document: query.get("document") ?? undefined, player: query.has("player") };
}
