// From the table of formats in crates/exchange/src/format.rs. `KATYDID_REFRESH_PAGES=1 cargo test -p katydid-exchange`
// writes it.

/** The formats that geometry is exported in, beside Rhino's own and pictures. */
export const EXCHANGE_FORMATS = ["obj", "stl", "ply", "glb", "gltf", "step", "svg"] as const;
