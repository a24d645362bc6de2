package org.phrenic.ui.view;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import javax.swing.JComponent;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;

/**
 * What is written over the view. Letters, figure and scale stay while the camera does, so they are drawn once and kept
 * as an image; the time is written over each frame.
 */
final class AnnotationLayer {
    private record Key(Annotations annotations, Camera camera, int width, int height, double scale) {}

    private Key layerKey;
    private BufferedImage layer;

    /** Draws over the picture of a component. */
    void draw(Graphics2D g, JComponent view, Annotations annotations, Camera camera) {
        int width = view.getWidth();
        int height = view.getHeight();
        double scale = g.getTransform().getScaleX();
        Key key = new Key(annotations.withTimestamp(""), camera, width, height, scale);
        if (!key.equals(layerKey)) {
            int w = (int) Math.ceil(width * scale);
            int h = (int) Math.ceil(height * scale);
            if (layer == null || layer.getWidth() != w || layer.getHeight() != h) {
                layer = new BufferedImage(w, h, BufferedImage.TYPE_INT_ARGB_PRE);
            }
            Graphics2D ink = layer.createGraphics();
            ink.setBackground(new java.awt.Color(0, true));
            ink.clearRect(0, 0, w, h);
            ink.scale(scale, scale);
            annotations.drawStatic(ink, camera, width, height, 1);
            ink.dispose();
            layerKey = key;
        }
        g.drawImage(layer, AffineTransform.getScaleInstance(1 / scale, 1 / scale), null);
        annotations.drawHeading(g, camera, width, height, 1);
    }
}
