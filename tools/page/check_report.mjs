// Writes a program of TypeScript that compiles only if src/report.ts has the fields that docs/report.schema.json has, no
// more and no fewer, and those of a report. usage: node check_report.mjs REPORT.json OUT.ts
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';

const [report, out] = process.argv.slice(2);
const here = import.meta.dirname;
const schema = JSON.parse(readFileSync(join(here, '../../docs/report.schema.json')));

// A value of this part of the schema: with all that it may have, or with what it must have alone.
function example(part, whole, choice = 0) {
  if (part.$ref) return example(schema.$defs[part.$ref.split('/').at(-1)], whole, choice);
  if (part.anyOf) return example(part.anyOf[choice % part.anyOf.length], whole, choice);
  if (part.enum) return part.enum[choice % part.enum.length];
  switch (part.type) {
    case 'object':
      return Object.fromEntries(Object.entries(part.properties).filter(([name]) => whole || part.required.includes(name))
        .map(([name, value]) => [name, example(value, whole, choice)]));
    case 'array': return Array.from({ length: part.minItems ?? 1 }, () => example(part.items, whole, choice));
    case 'string': return 'text';
    case 'boolean': return choice % 2 === 0;
    case 'null': return null;
    default: return 1;
  }
}

const cases = [JSON.parse(readFileSync(report)), ...[0, 1, 2].flatMap((choice) =>
  [true, false].map((whole) => example(schema.$defs.cooked, whole, choice)))];
const module = relative(dirname(out), join(here, 'src/report')).replace(/^(?!\.)/, './');
writeFileSync(out, `import type { Report } from '${module}';\n` +
  `export const reports: Report[] = [\n${cases.map((value) => JSON.stringify(value)).join(',\n')}];\n`);
