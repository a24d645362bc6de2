package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.simulation.observe.Surface;

/**
 * Draws faces of surfaces. Each combination of features is a program of its own, so that no pixel pays for what is not
 * asked for.
 */
final class SurfacePass {
    /** What a program can do besides lighting. */
    enum Feature {
        CLEAR,
        DULL,
        FIELD,
        TENDON,
        CLIP,
        CUT,
        PEEL
    }

    /** Which faces are drawn. */
    enum Faces {
        FRONT,
        BACK,
        BOTH
    }

    /**
     * What depth peeling draws: what lies before the opaque and behind the layer before.
     *
     * @param opaqueDepth texture
     * @param peeledDepth texture; not looked at for the first layer
     */
    record PeelLayer(int opaqueDepth, int peeledDepth, boolean first) {}

    /** Beyond this a clear surface is as good as opaque. */
    private static final float MAX_TRANSLUCENT_OPACITY = 0.9999f;

    private static final float EYE_OFFSET_MM = 5;
    private static final int COLOUR_MAP_SIZE = 256;
    private static final double GAMMA = 2.2;
    private static final float[] HIGHLIGHT_RGB = {1.0f, 0.62f, 0.10f};
    private static final float HIGHLIGHT_STRENGTH = 0.42f;

    private final GlResources objects;
    private final Map<Set<Feature>, ShaderProgram> programs = new HashMap<>();
    private final Map<ColourMap, Integer> colourMapTexture = new EnumMap<>(ColourMap.class);

    SurfacePass(GlResources objects) {
        this.objects = objects;
    }

    /** Draws one surface. */
    void draw(GL3 gl, SurfaceBuffers buffers, ViewTransform sight, SceneStyle style, Faces faces) {
        draw(gl, buffers, sight, style, faces, null);
    }

    /**
     * Draws of one surface what lies between two depths.
     *
     * @param layer the depths; null for all of it
     */
    void draw(GL3 gl, SurfaceBuffers buffers, ViewTransform sight, SceneStyle style, Faces faces, PeelLayer layer) {
        Surface surface = buffers.surface();
        Appearance look = style.appearance(surface.name()).orElseThrow();
        Set<Feature> features = EnumSet.noneOf(Feature.class);
        if (layer != null) {
            features.add(Feature.PEEL);
        }
        if (look.isTranslucent()) {
            features.add(Feature.CLEAR);
            if (faces == Faces.BACK) {
                features.add(Feature.DULL);
            }
        }
        if (style.showsField(surface.name())) {
            features.add(Feature.FIELD);
        } else if (surface.tendon().length > 0) {
            features.add(Feature.TENDON);
        }
        if (style.clip().isPresent()) {
            features.add(Feature.CLIP);
            if (!look.isTranslucent() && surface.kind() != StructureKind.SKIN) {
                features.add(Feature.CUT);
            }
        }
        ShaderProgram program = program(gl, features);
        program.use(gl);
        program.setMatrix(gl, "toEye", sight.toEyeSpace(buffers.pose()));
        program.setMatrix(gl, "projection", sight.projection());
        program.set(gl, "clip", sight.clipPlane(style.clip()));
        program.set(gl, "base", linear(look.rgb()));
        program.set(
                gl,
                "tendonBase",
                linear(Appearance.of(SurfaceMaterial.TENDON_RGB, 1).rgb()));
        SurfaceMaterial material = SurfaceMaterial.of(surface.kind());
        program.set(gl, "shine", material.specular(), material.shininess());
        program.set(gl, "parallel", sight.orthographicFlag());
        program.set(gl, "thinness", (float)
                (Math.log(1 - Math.min(look.opacity(), MAX_TRANSLUCENT_OPACITY)) / Math.log(2)));
        program.set(gl, "lift", surface.kind() == StructureKind.LUNG ? EYE_OFFSET_MM : 0);
        float accent = surface.name().equals(style.highlighted()) ? HIGHLIGHT_STRENGTH : 0;
        program.set(gl, "accent", HIGHLIGHT_RGB[0], HIGHLIGHT_RGB[1], HIGHLIGHT_RGB[2], accent);
        if (features.contains(Feature.FIELD)) {
            ColourScale scale = style.scale();
            gl.glActiveTexture(GL3.GL_TEXTURE0);
            gl.glBindTexture(GL3.GL_TEXTURE_1D, colourMapTexture(gl, scale.map()));
            program.setSampler(gl, "colours", 0);
            program.set(gl, "range", (float) scale.min(), (float) (1 / (scale.max() - scale.min())));
        }
        if (layer != null) {
            gl.glActiveTexture(GL3.GL_TEXTURE1);
            gl.glBindTexture(GL3.GL_TEXTURE_2D, layer.opaqueDepth());
            program.setSampler(gl, "opaqueDepth", 1);
            gl.glActiveTexture(GL3.GL_TEXTURE2);
            gl.glBindTexture(GL3.GL_TEXTURE_2D, layer.peeledDepth());
            program.setSampler(gl, "peeledDepth", 2);
            program.set(gl, "firstLayer", layer.first() ? 1f : 0f);
        }
        setCulling(gl, faces);
        buffers.draw(gl);
    }

    private static void setCulling(GL3 gl, Faces faces) {
        if (faces == Faces.BOTH) {
            gl.glDisable(GL3.GL_CULL_FACE);
        } else {
            gl.glEnable(GL3.GL_CULL_FACE);
            gl.glCullFace(faces == Faces.FRONT ? GL3.GL_BACK : GL3.GL_FRONT);
        }
    }

    private ShaderProgram program(GL3 gl, Set<Feature> features) {
        return programs.computeIfAbsent(features, key -> {
            StringBuilder defines = new StringBuilder();
            features.forEach(f -> defines.append("#define ").append(f).append('\n'));
            return new ShaderProgram(gl, objects, defines.toString(), "surface.vert.glsl", "surface.frag.glsl");
        });
    }

    private int colourMapTexture(GL3 gl, ColourMap map) {
        return colourMapTexture.computeIfAbsent(map, m -> {
            int texture = objects.texture(gl);
            gl.glBindTexture(GL3.GL_TEXTURE_1D, texture);
            gl.glTexImage1D(
                    GL3.GL_TEXTURE_1D,
                    0,
                    GL3.GL_RGB8,
                    COLOUR_MAP_SIZE,
                    0,
                    GL3.GL_RGB,
                    GL3.GL_FLOAT,
                    Buffers.newDirectFloatBuffer(m.table(COLOUR_MAP_SIZE)));
            gl.glTexParameteri(GL3.GL_TEXTURE_1D, GL3.GL_TEXTURE_MIN_FILTER, GL3.GL_LINEAR);
            gl.glTexParameteri(GL3.GL_TEXTURE_1D, GL3.GL_TEXTURE_MAG_FILTER, GL3.GL_LINEAR);
            gl.glTexParameteri(GL3.GL_TEXTURE_1D, GL3.GL_TEXTURE_WRAP_S, GL3.GL_CLAMP_TO_EDGE);
            return texture;
        });
    }

    private static float[] linear(float[] rgb) {
        float[] out = new float[3];
        for (int i = 0; i < 3; i++) {
            out[i] = (float) Math.pow(rgb[i], GAMMA);
        }
        return out;
    }

    void dispose(GL3 gl) {
        programs.values().forEach(p -> p.dispose(gl));
        colourMapTexture.values().forEach(t -> objects.deleteTexture(gl, t));
    }
}
