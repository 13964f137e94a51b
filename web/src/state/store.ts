// Holds the state and tells who listens.
import { useEffect, useState } from 'preact/hooks';
import { reduce, type Action } from './reduce';
import { kStart, type State } from './state';

export class Store {
  private state: State = kStart;
  private readonly listeners = new Set<() => void>();

  get(): State {
    return this.state;
  }

  dispatch(action: Action): void {
    const next = reduce(this.state, action);
    if (next === this.state) return;
    this.state = next;
    for (const listener of [...this.listeners]) listener();
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

export function useStore(store: Store): State {
  const [state, setState] = useState(store.get());
  useEffect(() => {
    setState(store.get());
    return store.subscribe(() => setState(store.get()));
  }, [store]);
  return state;
}
