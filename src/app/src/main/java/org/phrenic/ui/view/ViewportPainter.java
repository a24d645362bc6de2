package org.phrenic.ui.view;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.ui.widget.Theme;

/** Paints frames and their annotations into the viewport, or a text while there is no frame. */
final class ViewportPainter {
    private record LayerKey(Annotations annotations, Camera camera, int width, int height, double scale) {}

    /** Length of the arms of the cross in the middle, pixels. */
    private static final int ARM = 10;
    /** Widths of the dark and the light lines of the cross, pixels. */
    private static final float[] WIDTHS = {4, 1.5f};

    private final SceneViewport view;
    private LayerKey layerKey;
    private BufferedImage layer;

    ViewportPainter(SceneViewport view) {
        this.view = view;
    }

    /** Paints a frame; one of another size is centred, without distortion. */
    void paint(Graphics2D g, RenderedFrame frame, Annotations annotations) {
        BufferedImage image = frame.image();
        Camera camera = frame.request().camera();
        AffineTransform device = g.getTransform();
        int width = view.getWidth();
        int height = view.getHeight();
        boolean sameSize = image.getWidth() == Math.round(width * device.getScaleX())
                && image.getHeight() == Math.round(height * device.getScaleY());
        if (sameSize) {
            g.drawImage(image, AffineTransform.getScaleInstance(1 / device.getScaleX(), 1 / device.getScaleY()), null);
            frame.needleMarks().ifPresent(marks -> marks.drawOutlines(g, camera, width, height));
        } else {
            double fit = (double) height / image.getHeight();
            g.setColor(new Color(image.getRGB(0, 0)));
            g.fillRect(0, 0, width, height);
            AffineTransform place = AffineTransform.getTranslateInstance((width - fit * image.getWidth()) / 2, 0);
            place.scale(fit, fit);
            g.drawImage(image, place, null);
        }
        paintAnnotations(g, annotations, camera);
        if (view.isFocusOwner()
                && view.tool().filter(SceneViewport.MouseTool::isPicking).isPresent()) {
            paintCross(g);
        }
    }

    /** Marks the middle, where the Enter key picks. */
    private void paintCross(Graphics2D g) {
        int x = view.getWidth() / 2;
        int y = view.getHeight() / 2;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        for (int line = 0; line < WIDTHS.length; line++) {
            g.setColor(line == 0 ? Color.BLACK : Color.WHITE);
            g.setStroke(new BasicStroke(WIDTHS[line]));
            g.drawLine(x - ARM, y, x + ARM, y);
            g.drawLine(x, y - ARM, x, y + ARM);
        }
    }

    /** Draws the outlines of the needle over an image that is so many times as large as the view. */
    static void outlines(BufferedImage image, NeedleMarkers marks, Camera camera, int enlargement) {
        Graphics2D g = image.createGraphics();
        g.scale(enlargement, enlargement);
        marks.drawOutlines(g, camera, image.getWidth() / enlargement, image.getHeight() / enlargement);
        g.dispose();
    }

    /** Draws the annotations from an image that is kept while the camera stays, and the time over it. */
    private void paintAnnotations(Graphics2D g, Annotations annotations, Camera camera) {
        int width = view.getWidth();
        int height = view.getHeight();
        double scale = g.getTransform().getScaleX();
        LayerKey key = new LayerKey(annotations.withTimestamp(""), camera, width, height, scale);
        if (!key.equals(layerKey)) {
            int w = (int) Math.ceil(width * scale);
            int h = (int) Math.ceil(height * scale);
            if (layer == null || layer.getWidth() != w || layer.getHeight() != h) {
                layer = new BufferedImage(w, h, BufferedImage.TYPE_INT_ARGB_PRE);
            }
            Graphics2D ink = layer.createGraphics();
            ink.setBackground(new Color(0, true));
            ink.clearRect(0, 0, w, h);
            ink.scale(scale, scale);
            annotations.drawStatic(ink, camera, width, height, UIScale.getUserScaleFactor());
            ink.dispose();
            layerKey = key;
        }
        g.drawImage(layer, AffineTransform.getScaleInstance(1 / scale, 1 / scale), null);
        annotations.drawHeading(g, camera, width, height, UIScale.getUserScaleFactor());
    }

    /** Paints a text in the middle, broken into lines. */
    void paintPlaceholder(Graphics2D g, String text) {
        g.setColor(Theme.VIEW_BACKGROUND);
        g.fillRect(0, 0, view.getWidth(), view.getHeight());
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Theme.SECONDARY_TEXT);
        g.setFont(view.getFont() == null ? g.getFont() : view.getFont());
        FontMetrics metrics = g.getFontMetrics();
        int y = view.getHeight() / 2;
        for (String line : wrap(text, metrics, Math.max(80, view.getWidth() - 80))) {
            g.drawString(line, (view.getWidth() - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
    }

    /** Lines of at most {@code width} pixels, broken between words. */
    private static List<String> wrap(String text, FontMetrics metrics, int width) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ", -1)) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && metrics.stringWidth(longer) > width) {
                lines.add(line);
                line = word;
            } else {
                line = longer;
            }
        }
        lines.add(line);
        return lines;
    }
}
