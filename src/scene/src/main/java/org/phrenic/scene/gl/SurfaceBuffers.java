package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.surface.AmbientOcclusion;
import org.phrenic.scene.surface.CoarseTriangles;
import org.phrenic.scene.surface.FieldValues;
import org.phrenic.scene.surface.VertexAttributes;
import org.phrenic.scene.surface.VertexNormals;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** GPU buffers of one surface: vertex positions, normals and attributes, triangles, and edges on demand. */
final class SurfaceBuffers {
    private static final int POSITION = 0;
    private static final int NORMAL = 1;
    private static final int ATTRIBUTES = 2;
    private static final int FIELD = 3;
    /** Maximum fraction of boundary edges (one adjacent triangle) of a surface that is treated as closed. */
    private static final double MAX_OPEN_EDGE_SHARE = 0.02;

    private static final float[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    private final GlResources resources;
    private final Surface surface;
    private final int index;
    private final VertexNormals normals;
    private final FloatBuffer positions;
    private final IntBuffer packedNormals;
    private float[] poseRows = IDENTITY;
    private boolean posed;
    private final int vertexArray;
    private final int positionBuffer;
    private final int normalBuffer;
    private final int[] triangles;
    private final int triangleBuffer;
    private int coarseBuffer;
    private int coarseCount;
    private final int[] edges;
    private final boolean closed;
    private int restArray;
    private int edgeBuffer;
    private int fieldBuffer;
    private FieldValues values;
    private Optional<BoundingBox> box = Optional.empty();

    /**
     * @param index index of the surface in a frame
     * @param occlusion ambient occlusion of the scene
     */
    SurfaceBuffers(GL3 gl, GlResources resources, Surface surface, int index, AmbientOcclusion occlusion) {
        this.resources = resources;
        this.surface = surface;
        this.index = index;
        TriangleMesh mesh = surface.rest();
        triangles = orientedOutward(mesh);
        normals = new VertexNormals(triangles, mesh.vertexCount());
        float[] rest = restPositions();
        positions = Buffers.newDirectFloatBuffer(rest);
        packedNormals = Buffers.newDirectIntBuffer(mesh.vertexCount());
        normals.compute(rest, packedNormals);
        EdgeTable table = new EdgeTable(mesh);
        edges = table.edges();
        IntStream open = IntStream.range(0, table.edgeCount()).filter(e -> table.faceCount(e) == 1);
        closed = open.count() <= MAX_OPEN_EDGE_SHARE * table.edgeCount();
        int usage = surface.motion() == Surface.Motion.DEFORMING ? GL3.GL_STREAM_DRAW : GL3.GL_STATIC_DRAW;
        vertexArray = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
        gl.glBindVertexArray(vertexArray);
        positionBuffer = resources.createBuffer(gl, GL3.GL_ARRAY_BUFFER, positions, usage);
        attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        normalBuffer = resources.createBuffer(gl, GL3.GL_ARRAY_BUFFER, packedNormals, usage);
        attribute(gl, NORMAL, 4, GL3.GL_INT_2_10_10_10_REV, true);
        IntBuffer attributes = new VertexAttributes(surface, table).packed(occlusion.visibility(mesh, normals));
        resources.createBuffer(gl, GL3.GL_ARRAY_BUFFER, attributes, GL3.GL_STATIC_DRAW);
        attribute(gl, ATTRIBUTES, 4, GL3.GL_UNSIGNED_BYTE, true);
        triangleBuffer = elements(gl, triangles);
    }

    private float[] restPositions() {
        double[] rest = surface.rest().positions();
        float[] at = new float[rest.length];
        for (int i = 0; i < rest.length; i++) {
            at[i] = (float) rest[i];
        }
        return at;
    }

    private int elements(GL3 gl, int[] vertices) {
        IntBuffer content = Buffers.newDirectIntBuffer(vertices);
        return resources.createBuffer(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, content, GL3.GL_STATIC_DRAW);
    }

    private static void attribute(GL3 gl, int location, int size, int type, boolean normalized) {
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, size, type, normalized, 0, 0);
    }

    /** Triangles with outward orientation. Imported meshes may face inward; the signed volume is then negative. */
    private static int[] orientedOutward(TriangleMesh mesh) {
        int[] triangles = mesh.triangles().clone();
        if (MeshMeasure.signedVolume(mesh) < 0) {
            for (int t = 0; t < triangles.length; t += 3) {
                int swap = triangles[t];
                triangles[t] = triangles[t + 1];
                triangles[t + 1] = swap;
            }
        }
        return triangles;
    }

    /** Uploads the positions, or sets the pose, of the surface in a frame. */
    void upload(GL3 gl, Frame frame) {
        if (surface.motion() == Surface.Motion.RIGID) {
            setPose(frame.pose(index));
        } else if (surface.motion() == Surface.Motion.DEFORMING) {
            positions.put(0, frame.positions(index));
            box = Optional.empty();
            normals.compute(frame.positions(index), packedNormals);
            resources.stream(gl, positionBuffer, positions);
            resources.stream(gl, normalBuffer, packedNormals);
        }
    }

    /** Sets the pose, a row-major 3 x 4 matrix. */
    void setPose(float[] rows) {
        poseRows = rows.clone();
        posed = true;
    }

    /** Whether the surface looks the same in every frame: it neither moves nor has been given a pose. */
    boolean isStill() {
        return surface.motion() == Surface.Motion.STILL && !posed;
    }

    /** Uploads the vertex values of a quantity; {@code given} holds those of DISTANCE and ACCESS, null for zeros. */
    void uploadField(GL3 gl, ColourField field, float[] given) {
        if (values == null) {
            values = new FieldValues(surface);
            fieldBuffer = resources.create(gl, GlResources.Kind.BUFFER);
            gl.glBindVertexArray(vertexArray);
            gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, fieldBuffer);
            attribute(gl, FIELD, 1, GL3.GL_FLOAT, false);
        }
        boolean deforming = surface.motion() == Surface.Motion.DEFORMING;
        float[] shown =
                switch (field) {
                    case NONE -> values.zeros();
                    case DISTANCE, ACCESS -> given == null ? values.zeros() : given;
                    case STRAIN -> deforming ? values.areaStrain(positions) : values.zeros();
                    case DISPLACEMENT ->
                        switch (surface.motion()) {
                            case DEFORMING -> values.displacement(positions);
                            case RIGID -> values.displacement(poseRows);
                            case STILL -> values.zeros();
                        };
                };
        resources.stream(gl, fieldBuffer, FloatBuffer.wrap(shown));
    }

    /** Transform from rest coordinates to world coordinates. */
    Matrix4d pose() {
        float[] r = poseRows;
        return new Matrix4d(r[0], r[4], r[8], 0, r[1], r[5], r[9], 0, r[2], r[6], r[10], 0, r[3], r[7], r[11], 1);
    }

    /** The box of the present positions in the coordinates that {@link #pose} moves. */
    BoundingBox box() {
        if (box.isEmpty()) {
            box = Optional.of(BoundingBox.of(positions));
        }
        return box.get();
    }

    Surface surface() {
        return surface;
    }

    boolean isClosed() {
        return closed;
    }

    /** The surface at rest, with outward triangles. */
    TriangleMesh outward() {
        return new TriangleMesh(surface.rest().positions(), triangles);
    }

    /** Receives the triangles that are drawn on demand in place of all ({@link CoarseTriangles}). */
    void setCoarse(GL3 gl, int[] fewer) {
        gl.glBindVertexArray(vertexArray);
        coarseBuffer = elements(gl, fewer);
        coarseCount = fewer.length / 3;
    }

    /** Draws all triangles, or those of {@link #setCoarse}. */
    void draw(GL3 gl, boolean coarse) {
        int count = coarse ? coarseCount : triangles.length / 3;
        gl.glBindVertexArray(vertexArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, coarse ? coarseBuffer : triangleBuffer);
        gl.glDrawElements(GL3.GL_TRIANGLES, 3 * count, GL3.GL_UNSIGNED_INT, 0);
        resources.countDraw(count);
    }

    /** Draws the edges at the current or the rest positions. */
    void drawEdges(GL3 gl, boolean atRest) {
        if (edgeBuffer == 0) {
            gl.glBindVertexArray(vertexArray);
            edgeBuffer = elements(gl, edges);
        }
        gl.glBindVertexArray(atRest ? restArray(gl) : vertexArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, edgeBuffer);
        gl.glDrawElements(GL3.GL_LINES, edges.length, GL3.GL_UNSIGNED_INT, 0);
        resources.countDraw(edges.length);
    }

    private int restArray(GL3 gl) {
        if (restArray == 0) {
            restArray = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
            gl.glBindVertexArray(restArray);
            resources.createBuffer(
                    gl, GL3.GL_ARRAY_BUFFER, Buffers.newDirectFloatBuffer(restPositions()), GL3.GL_STATIC_DRAW);
            attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        }
        return restArray;
    }
}
