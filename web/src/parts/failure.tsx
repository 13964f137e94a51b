// Why something did not work: the sentence of the server, and its places.
import { ApiError } from '../api/client';
import { textOf } from '../state/shop';

export function Failure({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null;
  const details = error instanceof ApiError ? error.details : [];
  return (
    <div class="notice tone-bad" role="alert">
      <p>{textOf(error)}</p>
      {details.length > 0 && (
        <ul>
          {details.map((line) => (
            <li key={line}>{line}</li>
          ))}
        </ul>
      )}
    </div>
  );
}
