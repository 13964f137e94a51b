# Shows that the test of the drawings sees a changed table, and that nothing of a table is missing in its drawing.
import pathlib
import re
import shutil
import tempfile
import unittest

import states

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = ('protocol/feed/state.h', 'protocol/feed/state.cpp', 'server/app/lines/line.h', 'server/app/lines/feed_line_states.h', 'store/jobs.h',
         'store/jobs.cpp', 'store/releases.h', 'store/releases.cpp', 'store/orders.h', 'store/orders.cpp')


class States(unittest.TestCase):
    def copy_with(self, path, old, new):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name in FILES:
            target = pathlib.Path(folder.name) / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, target)
        changed = pathlib.Path(folder.name) / path
        text = changed.read_text()
        self.assertIn(old, text)
        changed.write_text(text.replace(old, new, 1))
        return pathlib.Path(folder.name)

    def test_a_changed_row_changes_its_drawings(self):
        before = dict(states.drawings(ROOT))
        for path, old, new, drawn in (
                ('protocol/feed/state.cpp', 'A::hold, S::held}', 'A::hold, S::stopped}', {'states-feed.svg'}),
                ('server/app/lines/feed_line_states.h', 'feed::State::torn, LineState::torn', 'feed::State::torn, LineState::idle', {'states-line.svg'}),
                ('store/jobs.cpp', 'JobTransition{armed, queued, true}', 'JobTransition{armed, held, true}', {'states-job.svg'}),
                ('store/releases.cpp', '.from = proving, .to = in_review', '.from = proving, .to = draft', {'states-release.svg'})):
            after = dict(states.drawings(self.copy_with(path, old, new)))
            self.assertEqual({name for name in before if before[name] != after[name]}, drawn, path)

    def test_a_row_that_cannot_be_read_is_noticed(self):
        root = self.copy_with('protocol/feed/state.cpp', '{S::idle, I::dc1, G::always, A::unarmed, S::idle},', '')
        with self.assertRaises(ValueError):
            list(states.drawings(root))

    def test_a_new_state_needs_a_place(self):
        root = self.copy_with('store/jobs.h', '  draining,  //', '  resting,\n  draining,  //')
        with self.assertRaises(ValueError):
            list(states.drawings(root))

    def test_each_move_is_written(self):
        machine = states.feed(ROOT)
        text = dict(states.drawings(ROOT))['states-feed.svg']
        shown = [re.sub(r'<[^>]*>', '', line) for line in text.splitlines() if line.startswith('<text')]
        for source, target in machine.moves:
            if source != target:
                self.assertTrue(any(line.startswith(f'→ {target}') for line in shown[shown.index(source) + 1:]), (source, target))


if __name__ == '__main__':
    unittest.main()
