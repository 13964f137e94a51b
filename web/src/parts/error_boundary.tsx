// A view that fails shows so in its place, and everything around it goes on: most of all the head with its alarms.
import { Component, type ComponentChildren } from 'preact';
import { t } from '../i18n/i18n';
import { textOf } from '../state/shop';

interface Props {
  where: string; // another place begins again
  children: ComponentChildren;
}

export class ErrorBoundary extends Component<Props, { error: unknown; where: string }> {
  override state = { error: null as unknown, where: this.props.where };

  static override getDerivedStateFromError(error: unknown) {
    return { error };
  }

  override componentDidUpdate() {
    if (this.state.error !== null && this.state.where !== this.props.where)
      this.setState({ error: null, where: this.props.where });
  }

  override render() {
    if (this.state.error === null) return this.props.children;
    return (
      <section class="notice tone-bad" role="alert">
        <h1 tabIndex={-1}>{t('broken.title')}</h1>
        <p>{t('broken.text')}</p>
        <p>
          <code>{textOf(this.state.error)}</code>
        </p>
        <button type="button" class="button" onClick={() => location.reload()}>
          {t('broken.reload')}
        </button>
      </section>
    );
  }
}
