// A view whose code is loaded when it is shown first, and a dialog whose code is loaded when it is asked for. What cannot be
// loaded is an error of the view, or of whoever asked.
import type { ComponentType, VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { loadAllWords, t } from '../i18n/i18n';
import { showDialog } from './dialog';

export function lazyView<Props extends object>(load: () => Promise<ComponentType<Props>>): ComponentType<Props> {
  let known: ComponentType<Props> | null = null;
  return function Lazy(props: Props) {
    const [view, setView] = useState<{ is: ComponentType<Props> } | null>(known ? { is: known } : null);
    const [error, setError] = useState<unknown>(null);
    useEffect(() => {
      if (view) return;
      Promise.all([load(), loadAllWords()]).then(([found]) => {
        known = found;
        setView({ is: found });
      }, setError);
    }, []);
    if (error !== null) throw error;
    if (!view)
      return (
        <p class="waiting" role="status">
          {t('page.loading')}
        </p>
      );
    const View = view.is;
    return <View {...props} />;
  };
}

export async function showLazyDialog<Code>(load: () => Promise<Code>, dialog: (code: Code) => VNode): Promise<void> {
  const [code] = await Promise.all([load(), loadAllWords()]);
  showDialog(dialog(code));
}
