// Names and values, two columns. What is null has no row.
import type { ComponentChildren } from 'preact';

export type Fact = [name: string, value: ComponentChildren | null];

export const Facts = ({ facts, strong = false }: { facts: readonly Fact[]; strong?: boolean }) => (
  <dl class={strong ? 'facts facts-strong' : 'facts'}>
    {facts.map(([name, value]) =>
      value === null ? null : (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ),
    )}
  </dl>
);
