import SCHEMA from "../../../../templates/scene.schema.json";

/** A part of the schema of scenes. */
interface Part {
  $ref?: string;
  description?: string;
  properties?: Record<string, Part>;
  additionalProperties?: Part | boolean;
  items?: Part;
  anyOf?: Part[];
  oneOf?: Part[];
  type?: string;
  const?: unknown;
  enum?: unknown[];
}

const ROOT = SCHEMA as unknown as Part & { $defs: Record<string, Part> };

/** A part and all forms that it may take, with references followed. */
function forms(part: Part): Part[] {
  const name = part.$ref?.split("/").at(-1);
  const referred = name === undefined ? [] : forms(ROOT.$defs[name] ?? {});
  return [part, ...referred, ...[...(part.anyOf ?? []), ...(part.oneOf ?? [])].flatMap(forms)];
}

/** What may stand at a path. */
function at(path: string[]): Part[] {
  let parts = forms(ROOT);
  for (const key of path) {
    parts = parts.flatMap(({ properties, additionalProperties, items }) => {
      const named = properties?.[key];
      const other = typeof additionalProperties === "object" ? additionalProperties : undefined;
      const next = named ?? other ?? (/^\d+$/.test(key) ? items : undefined);
      return next === undefined ? [] : forms(next);
    });
  }
  return parts;
}

/** What a key or value means; null where nothing is said. */
export function meaning(path: string[]): string | null {
  const said = at(path).find(({ description }) => description !== undefined);
  return said?.description ?? null;
}

/** Keys that an object at a path may have, with what they mean. */
export function keys(path: string[]): { name: string; about: string }[] {
  const found = new Map<string, string>();
  for (const { properties } of at(path)) {
    for (const [name, part] of Object.entries(properties ?? {})) if (!found.has(name)) found.set(name, part.description ?? "");
  }
  return [...found].map(([name, about]) => ({ name, about }));
}

/** Words that may stand at a path, with what they mean. */
export function values(path: string[]): { value: unknown; about: string }[] {
  return at(path).flatMap((part) => {
    const about = part.const === undefined ? "" : (part.description ?? "");
    const all = part.enum ?? (part.const === undefined ? (part.type === "boolean" ? [true, false] : []) : [part.const]);
    return all.map((value) => ({ value, about }));
  });
}
