// The catalogue's parts, which the bundler makes (words.mjs).
declare module 'words:*' {
  const words: Record<string, string>;
  export default words;
}
