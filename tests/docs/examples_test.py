# Shows that the test of examples reads the page, and that it refuses a program that does not do what stands there.
import os
import stat
import tempfile
import unittest

import examples

PAGE = '''# Diagnostics

## no-feed

*error*: …

This program has it (fanuc):

```nc
G1 X1.
```

This one does not:

```nc
G1 X1. F1.
```
'''


class Examples(unittest.TestCase):
    def checker(self, found):
        """A program that finds the diagnostic in every text, or in none."""
        file = tempfile.NamedTemporaryFile('w', delete=False)
        ids = '[{"id": "no-feed"}]' if found else '[]'
        file.write(f"""#!/bin/sh\ncat > /dev/null\nprintf '%s' '{{"files": [{{"diagnostics": {ids}}}]}}'\n""")
        file.close()
        os.chmod(file.name, stat.S_IRWXU)
        self.addCleanup(os.remove, file.name)
        return file.name

    def test_reads_the_page(self):
        self.assertEqual([('no-feed', 'fanuc', 'G1 X1.\n', True), ('no-feed', 'fanuc', 'G1 X1. F1.\n', False)], list(examples.examples(PAGE)))

    def test_refuses(self):
        self.assertIn('is found in the example without it', '\n'.join(examples.faults(self.checker(True), PAGE)))
        self.assertIn('is not found in its example', '\n'.join(examples.faults(self.checker(False), PAGE)))
        self.assertEqual(['no example at all'], examples.faults(self.checker(True), '# Nothing\n'))


if __name__ == '__main__':
    unittest.main()
