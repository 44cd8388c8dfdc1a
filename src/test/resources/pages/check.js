// Opens reports in a browser and fails where one is not accessible, wider than its window, in need of a network or of a script that works:
//     npm install axe-core puppeteer-core && node check.js CHROMIUM report.html...
// Light and dark on a desk, and on a phone. Prints violations of axe's rules, the height in pixels and how many pages it takes on A4.
const fs = require('fs');
const path = require('path');
const { createRequire } = require('module');

const here = createRequire(path.join(process.cwd(), 'package.json'));
const puppeteer = here('puppeteer-core');
const axe = fs.readFileSync(here.resolve('axe-core/axe.min.js'), 'utf8');
const [browserPath, ...reports] = process.argv.slice(2);
const windows = [[1280, 800, 'light'], [1280, 800, 'dark'], [390, 844, 'light']];

async function look(browser, report, width, height, scheme) {
  const page = await browser.newPage();
  const faults = [];
  page.on('pageerror', error => faults.push(String(error)));
  page.on('request', request => {
    if (!/^(file|data|blob):/.test(request.url())) {
      faults.push('asks for ' + request.url());
    }
  });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
  await page.setViewport({ width, height });
  await page.goto('file://' + path.resolve(report));
  await new Promise(resolve => setTimeout(resolve, 700)); // charts are drawn when they come into view
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run());
  found.violations.forEach(rule => faults.push(`${rule.id} (${rule.nodes.length})`));
  const [wide, high] = await page.evaluate(() => [document.documentElement.scrollWidth - window.innerWidth,
    document.documentElement.scrollHeight]);
  if (wide > 0) {
    faults.push(`${wide} px wider than its window`);
  }
  const printed = Buffer.from(await page.pdf({ format: 'A4' })).toString('latin1').match(/\/Type\s*\/Page\b/g).length;
  await page.close();
  console.log(`${report} ${width} ${scheme}: ${high} px, ${printed} pages, ${faults.length ? faults.join('; ') : 'no violation'}`);
  return faults.length;
}

(async () => {
  const browser = await puppeteer.launch({ executablePath: browserPath, args: ['--no-sandbox'] });
  let faults = 0;
  for (const report of reports) {
    for (const [width, height, scheme] of windows) {
      faults += await look(browser, report, width, height, scheme);
    }
  }
  await browser.close();
  process.exit(faults ? 1 : 0);
})();
