// Makes ../template.html from index.html and src/. With --check: says whether it is up to date.
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';

const here = new URL('.', import.meta.url);
const template = new URL('../template.html', here);
const placeOfData = '"wristwise data"';

async function bundle(entry) {
  const result = await build({
    entryPoints: [new URL(entry, here).pathname],
    bundle: true, minify: true, write: false, format: 'esm', target: 'es2022',
    charset: 'ascii', legalComments: 'none',
  });
  return result.outputFiles[0].text.trim();
}

const licences = ['three', 'uplot']
  .map((name) => {
    const { version, license } = JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, here)));
    const text = readFileSync(new URL(`node_modules/${name}/LICENSE`, here), 'utf8').trim();
    return `${name} ${version} (${license})\n\n${text}`;
  })
  .join('\n\n');
const script = await bundle('src/main.js');
const style = await bundle('src/style.css');
const page = readFileSync(new URL('index.html', here), 'utf8')
  .replace('<head>', () => `<!--\nContains:\n\n${licences}\n-->\n<head>`)
  .replace('/* style */', () => style)
  .replace('/* script */', () => script);

if (/<\/script/i.test(script)) throw new Error('the script ends itself');
if (page.split(placeOfData).length !== 2) throw new Error('the page needs one place for its data');

if (process.argv.includes('--check')) {
  if (readFileSync(template, 'utf8') !== page) {
    console.error('src/report/template.html is not what src/report/page gives: npm run build');
    process.exit(1);
  }
} else {
  writeFileSync(template, page);
  console.log(`template.html: ${(page.length / 1e3).toFixed(0)} kB`);
}
