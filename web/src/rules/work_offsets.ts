// Work offsets by the numbers that the server gives them.
const kPlain = 6; // G54 to G59

// '' of none.
export const offsetName = (number: number): string => {
  if (number === 0) return '';
  return number <= kPlain ? `G${53 + number}` : `P${number - kPlain}`;
};
