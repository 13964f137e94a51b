# The German of the page (web/src/i18n/de.json) against the English: the same messages with the same things put in, persons are
# addressed formally, and the words are those of the trade, the same one each time.
import json
import re
import sys

import tree

# What must not be written, and what is written instead. The left side is a regular expression.
TERMS = (
    (r'Sendebuch', 'Übertragungsbuch'),
    (r'Urteil', 'Prüfergebnis'),
    (r'scharf\s*stell|Scharfstell', 'scharf schalten'),
    (r'abgerissen\w*', 'zerrissener Satz'),
    (r'Flusskontrolle', 'Flusssteuerung'),
    (r'Geschwindigkeit der Leitung|Leitungsgeschwindigkeit', 'Baudrate'),
    (r'[Uu]mform', 'umschreiben: Umformen ist ein Fertigungsverfahren'),
    (r'ging weg', 'fiel ab, von einem Signal'),
    (r'(?<!Daten)[Bb]l[oö]ck(?:e|en|s)?\b', 'Satz, Sätze'),
    (r'Controller|CNC-Kontrolle', 'Steuerung'),
    (r'Toolpath|Werkzeugpfad|Werkzeugbahn', 'Werkzeugweg'),
    (r'Nullpunktoffset|Nullpunktversatz|Werkstückoffset', 'Nullpunktverschiebung'),
    (r'Werkzeugradiuskompensation|Fräserradius(?:korrektur|kompensation)', 'Werkzeugradiuskorrektur'),
    (r'\bFeed\b|Vorschubgeschwindigkeit', 'Vorschub'),
    (r'Schnellgang|Eilvorschub', 'Eilgang'),
    (r'Spindelgeschwindigkeit', 'Drehzahl'),
    (r'Verweildauer|Wartezeit im Satz', 'Verweilzeit'),
    (r'Notstopp|Not-Aus\b|Nothalt', 'Not-Halt'),
    (r'Vorschub Halt|Feed[ -]?[Hh]old', 'Vorschub-Halt'),
    (r'Handrad-?Modus|DNC-Modus', 'Nachladen (DNC)'),
    (r'Rohling|Rohmaterial', 'Rohteil'),
    (r'\bJobs?\b|\bTask', 'Auftrag'),
    (r'\bToken|\bLogin|\bLogout|\bUser|\bUpload|\bDownload|\bRelease\b|\bWaiver|\bReview\b', 'das deutsche Wort'),
    (r'Ausnahmegenehmigung|Freigaben und Ausnahmen', 'Billigung'),
    (r'genehmig', 'freigeben'),
)
FAMILIAR = re.compile(r'\b(?:du|dich|dir|dein\w*|euch|euer\w*|eure\w*)\b|\b(?:Wähle|Drücke|Öffne|Gib|Prüfe|Klicke|Starte|Speichere|Bestätige|Lies|Sieh)\b', re.I)
NAMED = re.compile(r'\{(\w+)(?:\}|,\s*(?:plural|select))')
SELECTED = re.compile(r'\{(\w+),\s*(plural|select)')


def faults(root):
    german = json.loads(tree.read(root, 'web/src/i18n/de.json'))
    english = json.loads(tree.read(root, 'web/src/i18n/en.json'))
    found = [f'de.json: {key} is missing' for key in english.keys() - german.keys()]
    found += [f'de.json: {key} is no message of en.json' for key in german.keys() - english.keys()]
    for key in english.keys() & german.keys():
        found += [f'de.json: {key}: {fault}' for fault in _of_message(german[key], english[key])]
    return sorted(found)


def _of_message(german, english):
    found = [] if german.strip() else ['is empty']
    for what, pattern in (('put in', NAMED), ('chosen by', SELECTED)):
        here, there = set(pattern.findall(german)), set(pattern.findall(english))
        if here != there and not (pattern is SELECTED and here <= there):
            found.append(f'{what}: {_names(here)} and in English {_names(there)}')
    found += [f'"{m[0]}": persons are addressed with Sie' for m in FAMILIAR.finditer(_spoken(german))]
    for term, right in TERMS:
        found += [f'"{m[0]}": write {right}' for m in re.finditer(term, _spoken(german))]
    return found


def _names(names):
    return ', '.join(sorted(n if isinstance(n, str) else ' '.join(n) for n in names)) or 'nothing'


def _spoken(message):
    """Without names of what is put in."""
    return re.sub(r'\{\w+\}|\{\w+, (?:plural|select),', ' ', message)


if __name__ == '__main__':
    tree.finish('german', faults(tree.root_of(sys.argv)))
