// Nothing is there: what that means, and the button that does something about it.
import type { ComponentChildren } from 'preact';

export const Empty = ({ children, action }: { children: ComponentChildren; action?: ComponentChildren }) => (
  <div class="empty">
    <p>{children}</p>
    {action}
  </div>
);

// A button that leads to where something can be done about it.
export const GoTo = ({ href, children }: { href: string; children: ComponentChildren }) => (
  <a class="button" href={href}>
    {children}
  </a>
);
