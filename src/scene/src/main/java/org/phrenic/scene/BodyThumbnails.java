package org.phrenic.scene;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.scene.SurfacePictures.Layer;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.Appearance;
import org.phrenic.simulation.observe.Surface;

/**
 * A contact sheet of bodies, up to {@value #BESIDE} side by side, with the states of each from the front, the right and
 * the back. A body's name stands above its row, the state and the side above each picture. The diaphragm and the organs
 * lie behind translucent bones and lungs; the skin is left out.
 */
public final class BodyThumbnails implements AutoCloseable {
    private static final List<AnatomicalView> VIEWS =
            List.of(AnatomicalView.ANTERIOR, AnatomicalView.RIGHT, AnatomicalView.POSTERIOR);
    /** Greatest number of bodies side by side. */
    private static final int BESIDE = 3;
    /** Number of bodies from which on another is set beside. */
    private static final int BELOW = 8;

    /** Height of the two lines above a row. */
    private static final int CAPTIONS_PX = 36;

    private static final int LINE_PX = 16;
    private static final int NAME_PX = 14;
    private static final int CAPTION_PX = 12;
    private static final Appearance ORGAN = Appearance.of(0x7fa37a, 1);
    private static final Map<StructureKind, Appearance> APPEARANCES = new EnumMap<>(StructureKind.class);

    static {
        Appearance bone = Appearance.of(0xd8cfae, 0.3f);
        APPEARANCES.put(StructureKind.DIAPHRAGM, Appearance.of(0xb9483c, 1));
        APPEARANCES.put(StructureKind.LIVER, Appearance.of(0x7a4a36, 1));
        APPEARANCES.put(StructureKind.ORGAN, ORGAN);
        APPEARANCES.put(StructureKind.LUNG, Appearance.of(0xd98f86, 0.25f));
        APPEARANCES.put(StructureKind.RIB, bone);
        APPEARANCES.put(StructureKind.COSTAL_CARTILAGE, bone);
        APPEARANCES.put(StructureKind.STERNUM, bone);
        APPEARANCES.put(StructureKind.VERTEBRA, bone);
    }

    private final SurfacePictures pictures;
    private final int width;
    private final int height;
    private final Map<String, List<Thumbnail>> rows = new HashMap<>();

    private record Thumbnail(BufferedImage image, String caption) {}

    /**
     * @param width of a thumbnail, pixels
     * @param height of a thumbnail, pixels
     * @throws NoGraphicsException if no OpenGL context is available; the message is one sentence
     */
    public BodyThumbnails(int width, int height) throws NoGraphicsException {
        this.width = width;
        this.height = height;
        pictures = new SurfacePictures();
    }

    /**
     * Adds a state of a body to its row. May be called from any thread.
     *
     * @param body name of the body
     * @param state such as {@code rest}
     * @param meshes positions of the surfaces, in their order
     */
    public synchronized void add(String body, String state, List<Surface> surfaces, List<TriangleMesh> meshes) {
        Map<Appearance, List<TriangleMesh>> parts = new LinkedHashMap<>();
        for (int i = 0; i < surfaces.size(); i++) {
            Appearance appearance = APPEARANCES.get(surfaces.get(i).kind());
            if (appearance != null) {
                parts.computeIfAbsent(appearance, kind -> new ArrayList<>()).add(meshes.get(i));
            }
        }
        List<Layer> layers = parts.entrySet().stream()
                .map(e -> new Layer(MeshMerge.merge(e.getValue()), e.getKey()))
                .toList();
        for (AnatomicalView view : VIEWS) {
            PictureSettings settings = new PictureSettings(view, width, height, true, 1, false, "");
            rows.computeIfAbsent(body, name -> new ArrayList<>())
                    .add(new Thumbnail(pictures.layers(layers, settings), state + ", " + view.label()));
        }
    }

    /** Whether no body has been added. */
    public synchronized boolean isEmpty() {
        return rows.isEmpty();
    }

    /**
     * Writes the sheet as PNG.
     *
     * @param bodies names of the bodies in the order of their rows; a body without pictures leaves its row empty
     * @throws IllegalStateException if none of the bodies has been added
     */
    public void write(Path file, List<String> bodies) {
        int columns = bodies.stream().mapToInt(body -> row(body).size()).max().orElse(0);
        if (columns == 0) {
            throw new IllegalStateException("found no body on the sheet of thumbnails, expected one");
        }
        int beside = Math.min(BESIDE, 1 + bodies.size() / BELOW);
        int below = (bodies.size() + beside - 1) / beside;
        BufferedImage sheet =
                new BufferedImage(beside * columns * width, below * (height + CAPTIONS_PX), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = sheet.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, sheet.getWidth(), sheet.getHeight());
        g.setColor(Color.BLACK);
        for (int i = 0; i < bodies.size(); i++) {
            draw(g, bodies.get(i), i % beside * columns * width, i / beside * (height + CAPTIONS_PX));
        }
        g.dispose();
        PngFile.write(file, sheet);
    }

    private List<Thumbnail> row(String body) {
        return rows.getOrDefault(body, List.of());
    }

    private void draw(Graphics2D g, String body, int left, int top) {
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, NAME_PX));
        g.drawString(body, left + 2, top + LINE_PX);
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, CAPTION_PX));
        int x = left;
        for (Thumbnail thumbnail : row(body)) {
            g.drawString(thumbnail.caption(), x + 2, top + 2 * LINE_PX);
            g.drawImage(thumbnail.image(), x, top + CAPTIONS_PX, null);
            x += width;
        }
    }

    @Override
    public void close() {
        pictures.close();
    }
}
