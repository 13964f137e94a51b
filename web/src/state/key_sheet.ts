// Whether "?" alone shows the sheet of keys: a person may turn it off, as for one who dictates a character is not an order.
const kStored = 'dripfeed.key_sheet';

export const hasKeySheetKey = (): boolean => localStorage.getItem(kStored) !== 'off';
export const keepKeySheetKey = (isOn: boolean): void => localStorage.setItem(kStored, isOn ? 'on' : 'off');
