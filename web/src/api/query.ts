// The query of a request, with its '?'. What is empty is not asked for.
export function queryOf(values: Record<string, string | number | null | undefined>): string {
  const asked = new URLSearchParams();
  for (const [name, value] of Object.entries(values)) if (value !== null && value !== undefined && value !== '') asked.set(name, String(value));
  const text = asked.toString();
  return text ? `?${text}` : '';
}
