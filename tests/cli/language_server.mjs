// What an editor shows of cases: the JSON language service of VS Code, with a schema, on texts from stdin.
// node language_server.mjs NODE_MODULES SCHEMA < [{ "name": …, "text": … }, …]; `¦` in a text is the cursor.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";

const [modules, file] = process.argv.slice(2);
const require = createRequire(resolve(modules, "any.js"));
const { getLanguageService, TextDocument } = require("vscode-json-languageservice");

const schema = JSON.parse(readFileSync(file, "utf8"));
const service = getLanguageService({ clientCapabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } } });
service.configure({ schemas: [{ uri: "case.schema.json", fileMatch: ["*"], schema }] });

const answers = [];
for (const { name, text } of JSON.parse(readFileSync(0, "utf8"))) {
  const cursor = text.indexOf("¦");
  const document = TextDocument.create(`file:///${name}.json`, "jsonc", 1, text.replace("¦", ""));
  const tree = service.parseJSONDocument(document);
  const marks = await service.doValidation(document, tree);
  const offers = cursor < 0 ? null : await service.doComplete(document, document.positionAt(cursor), tree);
  answers.push({
    name,
    marks: marks.map((mark) => ({ at: document.getText(mark.range), message: mark.message })),
    offers: (offers?.items ?? []).map((item) => ({ label: item.label, text: item.textEdit?.newText ?? item.insertText })),
  });
}
console.log(JSON.stringify(answers));
