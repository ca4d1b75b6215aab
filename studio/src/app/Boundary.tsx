import { Component, type ReactNode } from "react";

interface BoundaryProps {
  /** What is drawn: when it changes, it is tried again. */
  of?: unknown;
  fallback: ReactNode;
  children: ReactNode;
}

/** Where drawing something fails, its fallback stands in its place and the rest of the page goes on. */
export class Boundary extends Component<BoundaryProps, { hasFailed: boolean }> {
  override state = { hasFailed: false };

  static getDerivedStateFromError() {
    return { hasFailed: true };
  }

  override componentDidUpdate(before: BoundaryProps) {
    if (this.state.hasFailed && before.of !== this.props.of) this.setState({ hasFailed: false });
  }

  override render() {
    return this.state.hasFailed ? this.props.fallback : this.props.children;
  }
}
