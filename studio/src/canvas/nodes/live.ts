import { useEffect, useState } from "react";

/** A value that follows the pointer until the session has answered. */
export function useLive<T>(value: T): [T, (next: T | undefined) => void] {
  const [live, setLive] = useState<T | undefined>(undefined);
  useEffect(() => setLive(undefined), [value]);
  return [live ?? value, setLive];
}
