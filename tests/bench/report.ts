import type { Reporter, TestCase, TestResult } from "playwright/types/testReporter";
export default class Report implements Reporter {
  onTestEnd(_test: TestCase, { attachments }: TestResult): void {
    for (const { name, body } of attachments) console.log(name, String(body));
  }
}
