# Shows that the lint of the German page refuses what is missing, what is put in elsewhere, the familiar address and foreign terms.
import json
import unittest

import bad_tree
import german


class German(bad_tree.BadTree):
    def messages(self, english, of_page):
        self.write('web/src/i18n/en.json', json.dumps(english))
        self.write('web/src/i18n/de.json', json.dumps(of_page))

    def test_keys(self):
        self.messages({'a.b': 'Stop', 'a.c': 'Arm'}, {'a.b': 'Stopp'})
        self.assert_refused(german.faults, 'a.c is missing')
        self.messages({'a.b': 'Stop'}, {'a.b': 'Stopp', 'a.d': 'Neu'})
        self.assert_refused(german.faults, 'a.d is no message')
        self.messages({'a.b': 'Stop'}, {'a.b': ' '})
        self.assert_refused(german.faults, 'a.b: is empty')

    def test_what_is_put_in(self):
        self.messages({'a.b': 'Job {job}'}, {'a.b': 'Auftrag {number}'})
        self.assert_refused(german.faults, 'put in: number and in English job')
        self.messages({'a.b': '{n, plural, one {# line} other {# lines}}'}, {'a.b': '{m, plural, one {# Zeile} other {# Zeilen}}'})
        self.assert_refused(german.faults, 'chosen by')
        self.messages({'a.b': '{n, plural, one {# time} other {# times}}'}, {'a.b': '{n, plural, one {#-mal} other {#-mal}}'})
        self.assert_clean(german.faults)

    def test_address(self):
        for sentence in ('Hast du es geprüft?', 'Gib den Namen ein.', 'Deine PIN'):
            self.messages({'a.b': 'x'}, {'a.b': sentence})
            self.assert_refused(german.faults, 'addressed with Sie')
        self.messages({'a.b': 'x'}, {'a.b': 'Geben Sie Ihre PIN ein; die Durchsage endet.'})
        self.assert_clean(german.faults)

    def test_terms(self):
        for sentence in ('Der Block ist da', 'Den Text umformen', 'Das Urteil', 'Auftrag scharf stellen', 'Feed hold', 'Ein Upload'):
            self.messages({'a.b': 'x'}, {'a.b': sentence})
            self.assert_refused(german.faults, 'write ')
        self.messages({'a.b': '{upload} x'}, {'a.b': 'Satz {upload} umschreiben, das Prüfergebnis, Datenblock'})
        self.assert_clean(german.faults)


if __name__ == '__main__':
    unittest.main()
