// Shows the sheet of keys, whose code comes when it is asked for.
import { useEffect } from 'preact/hooks';
import { showDialog } from '../parts/dialog';
import { lazyView } from '../parts/lazy';
import { hasKeySheetKey } from '../state/key_sheet';

const KeySheet = lazyView(() => import('./keys').then((one) => one.KeySheet));
export const showKeys = (): void => showDialog(<KeySheet />);

// In a field the character is the person's, the editor's inside its shadow root too, and a dialog that is open stays the one.
const isTaken = ([place]: EventTarget[]): boolean =>
  document.querySelector('dialog') !== null || (place instanceof Element && place.closest('input,select,textarea,[contenteditable]') !== null);

export function useKeySheet(): void {
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (event.key === '?' && hasKeySheetKey() && !isTaken(event.composedPath())) showKeys();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, []);
}
