import type { Drawing } from "../piece";

/**
 * The pictures of a tab: by panel, and by the name of the component. Where two components of a panel have one name, the
 * key of the second has the first eight digits of its id behind the name.
 */
export type Tab = Readonly<Record<string, Readonly<Record<string, Drawing>>>>;
