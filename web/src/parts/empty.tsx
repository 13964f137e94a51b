// Nothing is there: what that means, and the button that does something about it.
import type { ComponentChildren } from 'preact';

export const Empty = ({ children, action }: { children: ComponentChildren; action?: ComponentChildren }) => (
  <div class="empty">
    <p>{children}</p>
    {action}
  </div>
);
