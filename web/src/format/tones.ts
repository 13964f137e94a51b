// What a state asks of the reader. The look of it is in the style sheet, and an icon goes with each.
export type Tone = 'quiet' | 'ready' | 'active' | 'waiting' | 'good' | 'bad';
