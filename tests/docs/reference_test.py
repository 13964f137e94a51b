# Shows that the test of generated sections sees a change, and that only these sections are written.
import unittest

import reference

API = {'paths': {'/a': {'get': {'summary': 'a | b', 'x-role': 'viewer'}}},
       'components': {'schemas': {'Inner': {'properties': {'x': {'type': ['number', 'null'], 'minimum': 0, 'maximum': 9}}},
                                  'Profile': {'required': ['name'], 'properties': {
                                      'name': {'type': 'string', 'description': 'of it'}, 'inner': {'$ref': '#/components/schemas/Inner'},
                                      'list': {'type': 'array', 'items': {'type': 'string'}}}}}}}
TABLES = {'routes': lambda: reference.route_table(API), 'profile': lambda: reference.profile_table(API)}


class Reference(unittest.TestCase):
    def test_sections(self):
        text = 'before\n<!-- generated: routes -->\nold\n<!-- end -->\nafter\n'
        new = reference.written(text, TABLES)
        self.assertNotEqual(text, new)
        self.assertEqual(new, reference.written(new, TABLES))
        self.assertTrue(new.startswith('before\n') and new.endswith('after\n') and 'old' not in new)
        self.assertIn('| `GET /a` | viewer | a \\| b |', new)

    def test_profile(self):
        rows = reference.profile_table(API)
        self.assertIn('| **`name`** | string | of it |', rows)
        self.assertIn('| `inner.x` | number, 0 to 9 |  |', rows)
        self.assertIn('| `list` | list of string |  |', rows)

    def test_problems(self):
        meanings = {'exists': '409: the name: taken'}
        api = {'components': {'schemas': {'Problem': {'properties': {'code': {'x-enumDescriptions': meanings}}}}}}
        self.assertEqual(reference.problem_table(api)[2:], ['| `exists` | 409 | the name: taken |'])


if __name__ == '__main__':
    unittest.main()
