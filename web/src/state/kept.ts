// What the browser keeps of a person's choices, as JSON by a name. What another version of the page has kept may be
// anything. A browser that keeps nothing gives null, and a choice lasts until the view is left.
const keyOf = (name: string): string => `dripfeed.${name}`;

export function keptAs(name: string): unknown {
  try {
    return JSON.parse(localStorage.getItem(keyOf(name)) ?? 'null');
  } catch {
    return null;
  }
}

// null: it is forgotten.
export function keepAs(name: string, value: object | null): void {
  try {
    if (value) localStorage.setItem(keyOf(name), JSON.stringify(value));
    else localStorage.removeItem(keyOf(name));
  } catch {
    // It is kept nowhere.
  }
}
