/** A component's picture on the page, in the colour of the text around it and the accent. */

import { useStore } from "zustand";

import { catalogueStore } from "../state/catalogue";
import { pictureOf, VIEW } from "./index";
import "./icons.css";

interface IconProps {
  /** The component's id. */
  component: string;
  /** Its name, by which what is not in the catalogue has its picture too. */
  name: string;
  size?: number;
}

export function Icon({ component, name, size = 24 }: IconProps) {
  const entry = useStore(catalogueStore, (catalogue) => catalogue.byId.get(component));
  return (
    <svg className="icon" viewBox={VIEW} width={size} height={size} aria-hidden="true" data-icon={name}>
      {pictureOf(component, entry?.name ?? name, entry).map(([tone, path]) => (
        <path key={tone} className={tone} d={path} />
      ))}
    </svg>
  );
}
