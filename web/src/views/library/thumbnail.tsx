// A program's toolpath as a small drawing. It is asked for when its row comes into sight, one after the other, and kept
// as long as the page is open: a revision never changes.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { PathPicture, Program } from '../../api/types';
import { t } from '../../i18n/i18n';
import { loader } from '../../state/loader';
import { textOf } from '../../state/shop';

type Drawn = PathPicture | { why_not: string };

const known = new Map<string, Drawn>();
let last: Promise<unknown> = Promise.resolve();

// After the drawings that were asked for before, unless the row is gone by then.
function draw({ id, revision }: Program, isWanted: () => boolean): Promise<Drawn | null> {
  const key = `${id} ${revision}`;
  const mine = last.then(async (): Promise<Drawn | null> => {
    const before = known.get(key);
    if (before || !isWanted()) return before ?? null;
    const drawn: Drawn = await loader.order(deskCalls.picture(id, revision)).catch((error: unknown) => ({ why_not: textOf(error) }));
    known.set(key, drawn);
    return drawn;
  });
  last = mine.catch(() => null);
  return mine;
}

export function Thumbnail({ program }: { program: Program }) {
  const place = useRef<HTMLSpanElement>(null);
  const [drawn, setDrawn] = useState<Drawn | null>(known.get(`${program.id} ${program.revision}`) ?? null);
  useEffect(() => {
    let isHere = true;
    const watcher = new IntersectionObserver(([seen]) => {
      if (!seen?.isIntersecting) return;
      watcher.disconnect();
      void draw(program, () => isHere).then((found) => isHere && found && setDrawn(found));
    });
    if (place.current) watcher.observe(place.current);
    return () => {
      isHere = false;
      watcher.disconnect();
    };
  }, [program.id, program.revision]);
  return (
    <span ref={place} class="thumbnail" data-drawn={drawn ? ('why_not' in drawn ? 'not' : drawn.view) : undefined}>
      {drawn && <Drawing of={drawn} name={program.name} />}
    </span>
  );
}

function Drawing({ of, name }: { of: Drawn; name: string }) {
  if ('why_not' in of) return <span title={of.why_not}>{t('thumbnail.none')}</span>;
  if (of.cut === '' && of.rapid === '') return of.has_all_cuts ? <span>{t('thumbnail.no_path')}</span> : <span title={t('thumbnail.not_run')}>{t('thumbnail.none')}</span>;
  const text = t(of.has_all_cuts ? 'thumbnail.of' : 'thumbnail.of_some', { name });
  return (
    <>
      <svg viewBox={`0 0 ${of.width} ${of.height}`} role="img" aria-label={text}>
        <path class="thumbnail-rapid" d={of.rapid} />
        <path class="thumbnail-cut" d={of.cut} />
      </svg>
      {!of.has_all_cuts && <span class="thumbnail-part" title={text}>…</span>}
    </>
  );
}
