/** The smallest change of one piece that makes `next` of `now`. */
export function smallest(now: string, next: string): { from: number; to: number; insert: string } {
  const most = Math.min(now.length, next.length);
  let same = 0;
  while (same < most && now[same] === next[same]) same += 1;
  let after = 0;
  while (after < most - same && now[now.length - 1 - after] === next[next.length - 1 - after]) after += 1;
  return { from: same, to: now.length - after, insert: next.slice(same, next.length - after) };
}
