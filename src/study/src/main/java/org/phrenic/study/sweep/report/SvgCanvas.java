package org.phrenic.study.sweep.report;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.file.Numbers;

/** A picture in SVG 1.1 of lines, areas and text. Coordinates are in pixels from the upper left corner. */
final class SvgCanvas {
    static final String INK = "#222222";
    static final String PALE = "#dddddd";
    static final String FIRST = "#0072b2";
    static final String SECOND = "#e69f00";
    static final String WIDE_BAND = "#cfe3f1";
    static final String NARROW_BAND = "#9fc8e4";

    private final StringBuilder text = new StringBuilder();

    SvgCanvas(double width, double height) {
        text.append(Numbers.format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1$.0f\" height=\"%2$.0f\""
                        + " viewBox=\"0 0 %1$.0f %2$.0f\" font-family=\"sans-serif\" font-size=\"12\">"
                        + "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>",
                width, height));
    }

    SvgCanvas line(double x1, double y1, double x2, double y2, String colour) {
        return polyline(new double[] {x1, x2}, new double[] {y1, y2}, colour, 1);
    }

    SvgCanvas polyline(double[] x, double[] y, String colour, double width) {
        text.append(Numbers.format(
                "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"/>",
                points(x, y), colour, width));
        return this;
    }

    SvgCanvas area(double[] x, double[] y, String colour) {
        text.append(Numbers.format("<polygon points=\"%s\" fill=\"%s\" stroke=\"none\"/>", points(x, y), colour));
        return this;
    }

    SvgCanvas bar(double x, double y, double width, double height, String colour) {
        text.append(Numbers.format(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" stroke=\"none\"/>",
                x, y, width, height, colour));
        return this;
    }

    SvgCanvas dot(double x, double y, String colour) {
        text.append(
                Numbers.format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"none\"/>", x, y, colour));
        return this;
    }

    /** @param anchor start, middle or end */
    SvgCanvas label(double x, double y, String anchor, String words) {
        text.append(Numbers.format(
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>",
                x, y, anchor, INK, HtmlPage.escaped(words)));
        return this;
    }

    private static String points(double[] x, double[] y) {
        StringBuilder points = new StringBuilder();
        for (int i = 0; i < x.length; i++) {
            points.append(Numbers.format("%.1f,%.1f ", x[i], y[i]));
        }
        return points.toString().strip();
    }

    /** The picture as a URL that contains it. */
    String dataUrl() {
        byte[] bytes = (text + "</svg>").getBytes(StandardCharsets.UTF_8);
        return "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(bytes);
    }
}
