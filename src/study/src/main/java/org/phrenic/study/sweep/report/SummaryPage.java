package org.phrenic.study.sweep.report;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.AtomicFile;

/** The summary of a study as a Markdown page, with its pictures as SVG files beside it. */
public final class SummaryPage {
    private static final String ENDING = ".md";

    private final Path file;
    private final ReportDocument summary;
    private int pictures;

    /**
     * @param file of the page; its pictures are called so, with a number
     * @param summary of {@link SweepReport#summary}
     */
    public SummaryPage(Path file, ReportDocument summary) {
        this.file = file;
        this.summary = summary;
    }

    /** Writes the pictures, then the page. */
    public void write() {
        ReportDocument page = new ReportDocument(summary.title(), summary.lead());
        for (ReportDocument.Block block : summary.blocks()) {
            if (block instanceof Figure figure) {
                List<Picture> beside = new ArrayList<>();
                figure.pictures().forEach(picture -> beside.add(beside(picture)));
                page.add(new Figure(figure.caption(), beside));
            } else {
                page.add(block);
            }
        }
        AtomicFile.write(file, MarkdownPage.format(page));
    }

    private Picture beside(Picture picture) {
        String page = file.getFileName().toString();
        String stem = page.endsWith(ENDING) ? page.substring(0, page.length() - ENDING.length()) : page;
        String name = stem + "-" + ++pictures + ".svg";
        String base64 = picture.source().substring(picture.source().indexOf(',') + 1);
        String svg = new String(Base64.getDecoder().decode(base64), StandardCharsets.UTF_8);
        AtomicFile.write(file.resolveSibling(name), svg + "\n");
        return new Picture(name, picture.alternative(), picture.caption());
    }
}
