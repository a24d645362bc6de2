package org.phrenic;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Sizes and names of the production sources: what a reader meets is short, has one name and stands in one place. */
class SourceRulesTest {
    private static final int COLUMNS = 120;
    private static final int FILE_LINES = 350;
    private static final int METHOD_LINES = 60;
    private static final int PARAMETERS = 7;
    private static final int EQUAL_LINES = 10;

    /**
     * The loops of the spring kernels are written out for each kind of spring: one loop for all costs 3 % of a step.
     */
    private static final String KERNEL = "Kernel.java";

    /** Newton's method for equilibrium stands beside the integrators and is neither of them nor large. */
    private static final Path SMALL_PACKAGE = Path.of("src/engine/src/main/java/org/phrenic/engine/equilibrium");

    private static final Pattern NO_CODE = Pattern.compile("(\\*|/\\*|//|import |package |[{}();]+$).*");

    /** Tables of measures and results, one component a column: the names at the place of use are those of the file. */
    private static final Path EXCEPTIONS = Path.of("src/app/src/test/resources/org/phrenic/source-rule-exceptions.txt");

    private static Map<Path, List<String>> sources;

    @BeforeAll
    static void read() throws IOException {
        sources = new TreeMap<>();
        for (Path file : SourceTree.files()) {
            if (isProduction(file)) {
                sources.put(file, Files.readAllLines(file));
            }
        }
    }

    private static boolean isProduction(Path file) {
        String path = file.toString().replace('\\', '/');
        return path.endsWith(".java") && path.contains("/src/main/java/");
    }

    private static boolean isIntroduction(Path file) {
        return file.endsWith("package-info.java");
    }

    /** Shaders, style sheets and build files keep to the columns of the sources. */
    @Test
    void linesEndAt120Columns() throws IOException {
        Map<Path, List<String>> all = new TreeMap<>(sources);
        all.put(Path.of("pom.xml"), Files.readAllLines(Path.of("pom.xml")));
        for (Path file : SourceTree.files()) {
            if (isOtherSource(file)) {
                all.put(file, Files.readAllLines(file));
            }
        }
        assertThat(all.keySet())
                .extracting(file -> file.toString().replaceAll(".*\\.", ""))
                .contains("java", "glsl", "css", "xml");
        List<String> found = new ArrayList<>();
        all.forEach((file, lines) -> {
            for (int i = 0; i < lines.size(); i++) {
                if (lines.get(i).codePointCount(0, lines.get(i).length()) > COLUMNS) {
                    found.add(file + ":" + (i + 1));
                }
            }
        });
        assertThat(found).isEmpty();
    }

    private static boolean isOtherSource(Path file) {
        String path = file.toString().replace('\\', '/');
        boolean resource = path.contains("/src/main/resources/") && (path.endsWith(".glsl") || path.endsWith(".css"));
        return resource || file.endsWith("pom.xml");
    }

    @Test
    void noFileIsLong() {
        assertThat(sources.keySet().stream().filter(file -> sources.get(file).size() > FILE_LINES))
                .isEmpty();
    }

    @Test
    void simpleNamesAreUnique() {
        assertThat(sources.keySet().stream()
                        .filter(file -> !isIntroduction(file))
                        .map(Path::getFileName))
                .doesNotHaveDuplicates();
    }

    @Test
    void packagesHoldFiveTo25Files() {
        Map<Path, Long> files = sources.keySet().stream()
                .filter(file -> !file.startsWith(SMALL_PACKAGE))
                .collect(Collectors.groupingBy(Path::getParent, TreeMap::new, Collectors.counting()));
        assertThat(files)
                .allSatisfy((folder, count) ->
                        assertThat(count).as(folder.toString()).isBetween(5L, 25L));
    }

    @Test
    void noTwoPlacesShareTenEqualLines() {
        Map<List<String>, String> first = new HashMap<>();
        Set<String> found = new TreeSet<>();
        sources.forEach((file, lines) -> {
            List<String> code = new ArrayList<>();
            List<Integer> at = new ArrayList<>();
            for (int i = 0; i < lines.size(); i++) {
                String line = lines.get(i).strip();
                if (!line.isEmpty() && !NO_CODE.matcher(line).matches()) {
                    code.add(line);
                    at.add(i + 1);
                }
            }
            for (int i = 0; i + EQUAL_LINES <= code.size(); i++) {
                String place = file + ":" + at.get(i);
                String before = first.putIfAbsent(List.copyOf(code.subList(i, i + EQUAL_LINES)), place);
                if (before != null && !(file.toString().endsWith(KERNEL) && before.contains(KERNEL))) {
                    found.add(before + " = " + place);
                }
            }
        });
        assertThat(found).isEmpty();
    }

    /** The exceptions are listed with their reason; one that is no longer needed turns this red as well. */
    @Test
    void methodsAreShortAndTakeFewParameters() throws IOException {
        Set<String> listed = Files.readAllLines(EXCEPTIONS).stream()
                .filter(line -> !line.isBlank() && !line.startsWith("#"))
                .map(line -> line.split(" ")[0])
                .collect(Collectors.toCollection(TreeSet::new));
        assertThat(overLimits()).isEqualTo(listed);
    }

    private static Set<String> overLimits() throws IOException {
        Set<String> found = new TreeSet<>();
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, manager, null, null, null, manager.getJavaFileObjectsFromPaths(sources.keySet()));
            SourcePositions positions = Trees.instance(task).getSourcePositions();
            for (CompilationUnitTree unit : task.parse()) {
                new LimitScanner(unit, positions, found).scan(unit, null);
            }
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        return found;
    }

    /** Collects methods over the limit of lines, and constructors and records over the limit of parameters. */
    private static final class LimitScanner extends TreePathScanner<Void, Void> {
        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final Set<String> found;

        LimitScanner(CompilationUnitTree unit, SourcePositions positions, Set<String> found) {
            this.unit = unit;
            this.positions = positions;
            this.found = found;
        }

        @Override
        public Void visitClass(ClassTree type, Void unused) {
            if (type.getKind() == Tree.Kind.RECORD) {
                long components = type.getMembers().stream()
                        .filter(member -> member.getKind() == Tree.Kind.VARIABLE)
                        .filter(member -> !member.toString().contains("static "))
                        .count();
                if (components > PARAMETERS) {
                    found.add(type.getSimpleName() + "(" + components + ")");
                }
            }
            return super.visitClass(type, unused);
        }

        @Override
        public Void visitMethod(MethodTree method, Void unused) {
            String owner = ((ClassTree) getCurrentPath().getParentPath().getLeaf())
                    .getSimpleName()
                    .toString();
            long start = unit.getLineMap().getLineNumber(positions.getStartPosition(unit, method));
            long end = unit.getLineMap().getLineNumber(positions.getEndPosition(unit, method));
            if (end - start + 1 > METHOD_LINES) {
                found.add(owner + "#" + method.getName() + "[lines]");
            }
            if (method.getReturnType() == null && method.getParameters().size() > PARAMETERS) {
                found.add(owner + "(" + method.getParameters().size() + ")");
            }
            return super.visitMethod(method, unused);
        }
    }
}
