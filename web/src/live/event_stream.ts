// The text/event-stream format: text in, in any pieces, events out. Comments are not events; that they came is seen from
// the bytes themselves.

export interface ServerEvent {
  name: string;
  data: string;
}

export class EventParser {
  lastId = '';
  private rest = '';
  private name = '';
  private data: string[] = [];
  private first = true;

  // The events that are whole now. A line may end with LF, CR LF or CR; a CR at the end of a piece waits for the next,
  // because an LF may follow it.
  push(piece: string): ServerEvent[] {
    let text = this.rest + piece;
    if (this.first && text !== '') {
      if (text.startsWith('\uFEFF')) text = text.slice(1);
      this.first = false;
    }
    const events: ServerEvent[] = [];
    let begin = 0;
    for (;;) {
      const end = text.slice(begin).search(/[\r\n]/);
      if (end < 0) break;
      const at = begin + end;
      if (text[at] === '\r' && at + 1 === text.length) break;
      this.line(text.slice(begin, at), events);
      begin = at + (text.startsWith('\r\n', at) ? 2 : 1);
    }
    this.rest = text.slice(begin);
    return events;
  }

  private line(line: string, events: ServerEvent[]): void {
    if (line === '') {
      if (this.data.length > 0) events.push({ name: this.name || 'message', data: this.data.join('\n') });
      this.name = '';
      this.data = [];
      return;
    }
    const colon = line.indexOf(':');
    if (colon === 0) return;
    const field = colon < 0 ? line : line.slice(0, colon);
    const value = colon < 0 ? '' : line.slice(colon + 1).replace(/^ /, '');
    if (field === 'event') this.name = value;
    if (field === 'data') this.data.push(value);
    if (field === 'id' && !value.includes('\0')) this.lastId = value;
  }
}
