package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
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

/** Draws the faces of surfaces. Each combination of features has its own shader program. */
final class SurfacePass {
    /** Optional features of the shader program. The names are preprocessor macros of the shaders. */
    private enum Feature {
        TRANSLUCENT,
        BACK_FACES,
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
     * Depth range of one layer of depth peeling: behind the previous layer and in front of the opaque surfaces.
     *
     * @param opaqueDepth depth texture of the opaque surfaces
     * @param peeledDepth depth texture of the previous layer; not read for the first layer
     */
    record PeelLayer(int opaqueDepth, int peeledDepth, boolean first) {}

    /** Upper bound of opacity that keeps log(1 - opacity) finite. */
    private static final float MAX_TRANSLUCENT_OPACITY = 0.9999f;

    private static final float LUNG_OFFSET_MM = 5;
    private static final int COLOUR_MAP_SIZE = 256;
    private static final double GAMMA = 2.2;
    private static final float[] HIGHLIGHT_RGB = {1.0f, 0.62f, 0.10f};
    private static final float HIGHLIGHT_STRENGTH = 0.42f;

    private final GlResources resources;
    private final Map<Set<Feature>, ShaderProgram> programs = new HashMap<>();
    private final Map<ColourMap, Integer> colourMapTextures = new EnumMap<>(ColourMap.class);

    private boolean coarse;

    SurfacePass(GlResources resources) {
        this.resources = resources;
    }

    /** Draws fewer triangles of each surface that shows no field from now on, or all. */
    void setCoarse(boolean fewer) {
        coarse = fewer;
    }

    boolean isCoarse() {
        return coarse;
    }

    void draw(GL3 gl, SurfaceBuffers buffers, ViewTransform transform, SceneStyle style, Faces faces) {
        draw(gl, buffers, transform, style, faces, null);
    }

    /**
     * Draws the part of a surface that lies in one layer of depth peeling.
     *
     * @param layer depth range; null for the whole surface
     */
    void draw(GL3 gl, SurfaceBuffers buffers, ViewTransform transform, SceneStyle style, Faces faces, PeelLayer layer) {
        Surface surface = buffers.surface();
        Appearance look = style.appearance(surface.name()).orElseThrow();
        SurfaceMaterial material = SurfaceMaterial.of(surface.kind(), surface.name());
        Set<Feature> features = features(surface, look, style, faces);
        if (layer != null) {
            features.add(Feature.PEEL);
        }
        ShaderProgram program = program(gl, features);
        program.use(gl, transform, style, transform.toEyeSpace(buffers.pose()));
        program.set(gl, "base", linear(look));
        program.set(gl, "tendonBase", linear(Appearance.of(SurfaceMaterial.TENDON_RGB, 1)));
        program.set(gl, "shine", material.specular(), material.shininess());
        double transparency = 1 - Math.min(look.opacity(), MAX_TRANSLUCENT_OPACITY);
        program.set(gl, "thinness", (float) (Math.log(transparency) / Math.log(2)));
        program.set(gl, "lift", surface.kind() == StructureKind.LUNG ? LUNG_OFFSET_MM : 0);
        // A tint would change the values that colours tell.
        boolean tinted = surface.name().equals(style.highlighted()) && !style.showsField(surface.name());
        float accent = tinted ? HIGHLIGHT_STRENGTH : 0;
        program.set(gl, "accent", HIGHLIGHT_RGB[0], HIGHLIGHT_RGB[1], HIGHLIGHT_RGB[2], accent);
        if (features.contains(Feature.FIELD)) {
            ColourScale scale = style.scale();
            program.setTexture(gl, "colours", 0, GL3.GL_TEXTURE_1D, colourMapTexture(gl, scale.map()));
            program.set(gl, "range", (float) scale.min(), (float) (1 / (scale.max() - scale.min())));
        }
        if (layer != null) {
            program.setTexture(gl, "opaqueDepth", 1, GL3.GL_TEXTURE_2D, layer.opaqueDepth());
            program.setTexture(gl, "peeledDepth", 2, GL3.GL_TEXTURE_2D, layer.peeledDepth());
            program.set(gl, "firstLayer", layer.first() ? 1f : 0f);
        }
        setCulling(gl, faces);
        // Values are known at all vertices.
        buffers.draw(gl, coarse && !features.contains(Feature.FIELD));
    }

    private static Set<Feature> features(Surface surface, Appearance look, SceneStyle style, Faces faces) {
        Set<Feature> features = EnumSet.noneOf(Feature.class);
        if (look.isTranslucent()) {
            features.add(Feature.TRANSLUCENT);
            if (faces == Faces.BACK) {
                features.add(Feature.BACK_FACES);
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
        return features;
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
            return new ShaderProgram(gl, resources, defines.toString(), "surface.vert.glsl", "surface.frag.glsl");
        });
    }

    private int colourMapTexture(GL3 gl, ColourMap map) {
        return colourMapTextures.computeIfAbsent(map, m -> {
            int target = GL3.GL_TEXTURE_1D;
            int texture = resources.create(gl, GlResources.Kind.TEXTURE);
            FloatBuffer table = Buffers.newDirectFloatBuffer(m.table(COLOUR_MAP_SIZE));
            gl.glBindTexture(target, texture);
            gl.glTexImage1D(target, 0, GL3.GL_RGB8, COLOUR_MAP_SIZE, 0, GL3.GL_RGB, GL3.GL_FLOAT, table);
            gl.glTexParameteri(target, GL3.GL_TEXTURE_MIN_FILTER, GL3.GL_LINEAR);
            gl.glTexParameteri(target, GL3.GL_TEXTURE_MAG_FILTER, GL3.GL_LINEAR);
            gl.glTexParameteri(target, GL3.GL_TEXTURE_WRAP_S, GL3.GL_CLAMP_TO_EDGE);
            return texture;
        });
    }

    private static float[] linear(Appearance look) {
        float[] linear = look.rgb().clone();
        for (int i = 0; i < 3; i++) {
            linear[i] = (float) Math.pow(linear[i], GAMMA);
        }
        return linear;
    }
}
