package org.phrenic.document.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** A report says the same in HTML and Markdown, and what stands in its texts is never taken for mark-up. */
class ReportPagesTest {
    private static final String NASTY = "<script>alert(\"a & 'b'\")</script> | *x* _y_ `z` [l](u)";

    private static ReportDocument report() {
        return new ReportDocument(NASTY, "What it is.")
                .section("Speed")
                .paragraph(NASTY)
                .remark("Not there yet.")
                .points("one", NASTY)
                .code("phrenic reproduce --out a<b")
                .section("Speed")
                .table(
                        "Iterations a second",
                        List.of(Column.text("resolution"), Column.number("paper")),
                        List.of(List.of("High resolution"), List.of("20909", "8.13"), List.of(NASTY, "1")))
                .section("Third")
                .section("???")
                .figure("Fig. 1. Two pictures.", new Picture("pictures/a.png", NASTY, "left"));
    }

    private static Document parsed(String page) throws Exception {
        return DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(page.getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void aPageIsWellFormedAndHoldsTextsAsTheyWereGiven() throws Exception {
        Document page = parsed(HtmlPage.format(report()));
        assertThat(page.getElementsByTagName("script").getLength()).isZero();
        assertThat(page.getElementsByTagName("h1").item(0).getTextContent()).isEqualTo(NASTY);
        assertThat(page.getElementsByTagName("li").item(5).getTextContent()).isEqualTo(NASTY);
        assertThat(((Element) page.getElementsByTagName("img").item(0)).getAttribute("alt"))
                .isEqualTo(NASTY);
    }

    @Test
    void aPageFetchesNothingFromElsewhere() {
        assertThat(HtmlPage.format(report())).doesNotContain("http:", "https:", "url(", "@import", "<link");
    }

    @Test
    void contentsLeadToTheSectionsEvenWhereHeadingsAreAlikeOrHaveNoLetters() throws Exception {
        Document page = parsed(HtmlPage.format(report()));
        List<String> targets = java.util.stream.IntStream.range(
                        0, page.getElementsByTagName("a").getLength())
                .mapToObj(i -> ((Element) page.getElementsByTagName("a").item(i)).getAttribute("href"))
                .toList();
        List<String> anchors = java.util.stream.IntStream.range(
                        0, page.getElementsByTagName("h2").getLength())
                .mapToObj(i -> "#" + ((Element) page.getElementsByTagName("h2").item(i)).getAttribute("id"))
                .toList();
        assertThat(targets).isEqualTo(anchors).doesNotHaveDuplicates().hasSize(4);
    }

    @Test
    void numbersStandToTheRightAndHeadingsWithinATableSpanIt() {
        assertThat(HtmlPage.format(report()))
                .contains("<td class=\"number\">8.13</td>")
                .contains("<th scope=\"rowgroup\" colspan=\"2\">High resolution</th>");
        assertThat(MarkdownPage.format(report())).contains("|---|---:|").contains("| **High resolution** | |");
    }

    @Test
    void everyReportCarriesTheNotice() {
        assertThat(HtmlPage.format(report())).contains(Disclaimer.TEXT);
        assertThat(MarkdownPage.format(report())).contains(Disclaimer.TEXT);
    }

    @Test
    void markdownTakesMarkUpLiterally() {
        assertThat(MarkdownPage.format(report()))
                .contains("\n\\<script\\>alert(\"a & 'b'\")\\</script\\> \\| \\*x\\* \\_y\\_ \\`z\\` \\[l\\](u)\n")
                .contains("    phrenic reproduce --out a<b\n")
                .contains("](pictures/a.png)");
    }

    /** A page is written beside its pictures, which are called as it is. */
    @Test
    void aPictureIsFoundWhateverItsFileIsCalled() throws Exception {
        String file = "pictures/my (best) 50 % \u00e4 #1?-1.svg";
        ReportDocument report = new ReportDocument("t", "").figure("f", new Picture(file, "a", ""));
        String link = "pictures/my%20%28best%29%2050%20%25%20\u00e4%20%231%3F-1.svg";
        assertThat(MarkdownPage.format(report)).contains("\n![a](" + link + ")\n");
        Element image = (Element)
                parsed(HtmlPage.format(report)).getElementsByTagName("img").item(0);
        assertThat(image.getAttribute("src")).isEqualTo(link);
        assertThat(URI.create(link).getPath()).isEqualTo(file);
        String data = "data:image/svg+xml;base64,PHN2Zy8+PQ==";
        assertThat(MarkdownPage.format(new ReportDocument("t", "").figure("f", new Picture(data, "a", ""))))
                .contains("(" + data + ")");
    }

    @Test
    void whatXmlCannotHoldIsReplaced() throws Exception {
        String page = HtmlPage.format(new ReportDocument("a\u0000b\ud800c", "").paragraph("\u0085\uffff\t"));
        assertThat(parsed(page).getElementsByTagName("h1").item(0).getTextContent())
                .isEqualTo("a\ufffdb\ufffdc");
    }

    @Test
    void aRowOfAnotherLengthIsRefused() {
        List<Column> columns = List.of(Column.text("a"), Column.text("b"), Column.text("c"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ReportDocument("t", "").table("T", columns, List.of(List.of("1", "2"))))
                .withMessage("table 'T': found a row of 2 cells, expected 3 or 1");
    }
}
