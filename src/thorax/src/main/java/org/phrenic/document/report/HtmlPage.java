package org.phrenic.document.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.phrenic.document.report.ReportDocument.Block;
import org.phrenic.document.report.ReportDocument.Code;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Paragraph;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.document.report.ReportDocument.Points;
import org.phrenic.document.report.ReportDocument.Remark;
import org.phrenic.document.report.ReportDocument.Section;
import org.phrenic.document.report.ReportDocument.Table;

/**
 * Formats a {@link ReportDocument} as one HTML page that is also well-formed XML. It has an embedded style sheet, no
 * scripts and no external resources. In A4 print, page breaks do not divide table rows or figures.
 */
public final class HtmlPage {
    /** Least number of sections for a table of contents. */
    private static final int MIN_SECTIONS_FOR_CONTENTS = 4;
    /** Tables with up to this number of rows are kept on one page. */
    private static final int MAX_UNBROKEN_ROWS = 8;

    private final StringBuilder text = new StringBuilder();
    private final List<String> anchors = new ArrayList<>();

    private HtmlPage() {}

    /** Formats a report as HTML. */
    public static String format(ReportDocument document) {
        return new HtmlPage().page(document);
    }

    /** Escapes a text for HTML content and attributes. */
    public static String escaped(String plain) {
        StringBuilder out = new StringBuilder(plain.length() + 16);
        plain.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> out.append("&amp;");
                case '<' -> out.append("&lt;");
                case '>' -> out.append("&gt;");
                case '"' -> out.append("&quot;");
                case '\'' -> out.append("&#39;");
                default -> {
                    boolean allowed = c == '\n' || c == '\t' || !Character.isISOControl(c);
                    boolean whole = c < Character.MIN_SURROGATE || c > Character.MAX_SURROGATE;
                    out.appendCodePoint(allowed && whole && c != 0xfffe && c != 0xffff ? c : 0xfffd);
                }
            }
        });
        return out.toString();
    }

    private String page(ReportDocument document) {
        String title = escaped(document.title());
        text.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .append("<title>" + title + "</title>\n<style>\n" + style() + "</style>\n</head>\n<body>\n")
                .append("<header>\n<h1>" + title + "</h1>\n")
                .append(document.lead().isEmpty() ? "" : "<p class=\"lead\">" + escaped(document.lead()) + "</p>\n")
                .append("<p class=\"notice\">" + escaped(Disclaimer.TEXT) + "</p>\n</header>\n");
        contents(document);
        text.append("<main>\n");
        document.blocks().forEach(this::block);
        return text.append("</main>\n<footer>\n<p class=\"notice\">" + escaped(Disclaimer.TEXT))
                .append("</p>\n</footer>\n</body>\n</html>\n")
                .toString();
    }

    private static String style() {
        try (InputStream in = HtmlPage.class.getResourceAsStream("report.css")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void contents(ReportDocument document) {
        List<String> headings = document.blocks().stream()
                .filter(Section.class::isInstance)
                .map(b -> ((Section) b).heading())
                .toList();
        if (headings.size() >= MIN_SECTIONS_FOR_CONTENTS) {
            text.append("<nav>\n<ol>\n");
            List<String> used = new ArrayList<>();
            for (String heading : headings) {
                text.append("<li><a href=\"#" + anchor(heading, used) + "\">" + escaped(heading) + "</a></li>\n");
            }
            text.append("</ol>\n</nav>\n");
        }
    }

    /** A unique anchor name for a heading, which is added to {@code used}. */
    private static String anchor(String heading, List<String> used) {
        String plain =
                heading.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
        String name = plain;
        for (int i = 2; name.isEmpty() || used.contains(name); i++) {
            name = plain + "-" + i;
        }
        used.add(name);
        return name;
    }

    private void block(Block block) {
        if (block instanceof Section section) {
            String id = anchor(section.heading(), anchors);
            text.append("<h2 id=\"" + id + "\">" + escaped(section.heading()) + "</h2>\n");
        } else if (block instanceof Paragraph paragraph) {
            text.append("<p>" + escaped(paragraph.text()) + "</p>\n");
        } else if (block instanceof Remark remark) {
            text.append("<p class=\"remark\">" + escaped(remark.text()) + "</p>\n");
        } else if (block instanceof Points points) {
            text.append("<ul>\n");
            points.items().forEach(item -> text.append("<li>" + escaped(item) + "</li>\n"));
            text.append("</ul>\n");
        } else if (block instanceof Code code) {
            text.append("<pre>" + escaped(code.lines()) + "</pre>\n");
        } else if (block instanceof Table table) {
            table(table);
        } else if (block instanceof Figure figure) {
            figure(figure);
        }
    }

    private void table(Table table) {
        text.append(
                "<div class=\"wide" + (table.rows().size() <= MAX_UNBROKEN_ROWS ? " short" : "") + "\">\n<table>\n");
        if (!table.caption().isEmpty()) {
            text.append("<caption>" + escaped(table.caption()) + "</caption>\n");
        }
        text.append("<thead>\n<tr>"
                + table.columns().stream()
                        .map(c -> "<th scope=\"col\"" + numberClass(c) + ">" + escaped(c.heading()) + "</th>")
                        .collect(Collectors.joining())
                + "</tr>\n</thead>\n<tbody>\n");
        for (List<String> row : table.rows()) {
            text.append("<tr>");
            if (row.size() == 1 && table.columns().size() > 1) {
                text.append("<th scope=\"rowgroup\" colspan=\""
                        + table.columns().size() + "\">" + escaped(row.get(0)) + "</th>");
            } else {
                for (int c = 0; c < row.size(); c++) {
                    text.append("<td" + numberClass(table.columns().get(c)) + ">" + escaped(row.get(c)) + "</td>");
                }
            }
            text.append("</tr>\n");
        }
        text.append("</tbody>\n</table>\n</div>\n");
    }

    private static String numberClass(Column column) {
        return column.number() ? " class=\"number\"" : "";
    }

    private void figure(Figure figure) {
        text.append("<figure>\n<div class=\"" + (figure.pictures().size() > 1 ? "several" : "one") + "\">\n");
        for (Picture picture : figure.pictures()) {
            text.append("<div><img src=\"" + escaped(picture.url()) + "\" alt=\"" + escaped(picture.alternative())
                    + "\"/>");
            text.append(picture.caption().isEmpty() ? "" : "<span>" + escaped(picture.caption()) + "</span>");
            text.append("</div>\n");
        }
        text.append("</div>\n<figcaption>" + escaped(figure.caption()) + "</figcaption>\n</figure>\n");
    }
}
