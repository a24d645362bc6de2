package org.phrenic.document.report;

import java.util.List;
import java.util.stream.Collectors;
import org.phrenic.document.report.ReportDocument.Block;
import org.phrenic.document.report.ReportDocument.Code;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Paragraph;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.document.report.ReportDocument.Points;
import org.phrenic.document.report.ReportDocument.Remark;
import org.phrenic.document.report.ReportDocument.Section;
import org.phrenic.document.report.ReportDocument.Table;

/** Formats a {@link ReportDocument} as Markdown with GitHub tables. */
public final class MarkdownPage {
    private MarkdownPage() {}

    /** Formats a report as Markdown. */
    public static String format(ReportDocument document) {
        return "# " + escaped(document.title()) + "\n\n"
                + (document.lead().isEmpty() ? "" : escaped(document.lead()) + "\n\n")
                + "**" + Disclaimer.TEXT + "**\n"
                + document.blocks().stream().map(MarkdownPage::block).collect(Collectors.joining());
    }

    /** Escapes a text for Markdown: Markdown and HTML syntax is shown literally, and a line break becomes a space. */
    public static String escaped(String plain) {
        return cell(plain).replaceAll("^([#+-])", "\\\\$1");
    }

    private static String cell(String plain) {
        return plain.replaceAll("\\s*\\R\\s*", " ").replaceAll("([\\\\`*_\\[\\]|<>])", "\\\\$1");
    }

    private static String block(Block block) {
        if (block instanceof Section section) {
            return "\n## " + escaped(section.heading()) + "\n";
        }
        if (block instanceof Paragraph paragraph) {
            return "\n" + escaped(paragraph.text()) + "\n";
        }
        if (block instanceof Remark remark) {
            return "\n> " + escaped(remark.text()) + "\n";
        }
        if (block instanceof Points points) {
            return "\n"
                    + points.items().stream().map(i -> "- " + escaped(i) + "\n").collect(Collectors.joining());
        }
        if (block instanceof Code code) {
            return "\n"
                    + code.lines().strip().lines().map(l -> "    " + l + "\n").collect(Collectors.joining());
        }
        if (block instanceof Table table) {
            return table(table);
        }
        return figure((Figure) block);
    }

    private static String table(Table table) {
        StringBuilder text = new StringBuilder(table.caption().isEmpty() ? "" : "\n" + escaped(table.caption()) + "\n");
        text.append("\n| ")
                .append(table.columns().stream().map(c -> cell(c.heading())).collect(Collectors.joining(" | ")))
                .append(" |\n|")
                .append(table.columns().stream()
                        .map(c -> c.number() ? "---:|" : "---|")
                        .collect(Collectors.joining()))
                .append('\n');
        int width = table.columns().size();
        for (List<String> row : table.rows()) {
            text.append("| ");
            text.append(
                    row.size() < width
                            ? "**" + cell(row.get(0)) + "**" + " |".repeat(width - 1)
                            : row.stream().map(MarkdownPage::cell).collect(Collectors.joining(" | ")));
            text.append(" |\n");
        }
        return text.toString();
    }

    private static String figure(Figure figure) {
        StringBuilder text = new StringBuilder();
        for (Picture picture : figure.pictures()) {
            text.append("\n![" + escaped(picture.alternative()) + "](" + picture.url() + ")\n");
            text.append(picture.caption().isEmpty() ? "" : "\n" + escaped(picture.caption()) + "\n");
        }
        return text + "\n" + escaped(figure.caption()) + "\n";
    }
}
