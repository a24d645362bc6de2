package org.phrenic;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/**
 * What a reader of the documents relies on: links lead somewhere, the list of dependencies is the build's, every
 * package is introduced.
 */
class DocumentsTest {
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");
    private static final Pattern FENCE = Pattern.compile("(?ms)^```.*?^```$");
    private static final Pattern ARTIFACT_ROW = Pattern.compile("(?m)^\\| `([^`]+)` \\| ([^ |]+) \\|");
    private static final Pattern PROPERTY = Pattern.compile("\\$\\{(.*)}");

    /** A method in the text, such as {@code `checkpoint()`}. */
    private static final Pattern METHOD = Pattern.compile("`(?:\\w+\\.)*([a-z]\\w+)\\([^`]*\\)`");

    private static final Pattern DECLARED = Pattern.compile("(?<=[\\w>\\]] )(\\w+)\\(");
    private static final Set<String> METHODS_OF_SOURCES = new HashSet<>();

    private static final Path README = Path.of("README.md");
    private static final Path MAP = Path.of("docs/README.md");

    private static final Path RESULTS = Path.of("docs/results");
    /** Its text is that of the declarations, a paragraph a line. */
    private static final Path PARAMETERS = Path.of("docs/parameters.md");
    /** A page that is longer than this is two. */
    private static final int MOST_LINES = 200;
    /** Where prose is broken, columns. */
    private static final int MARGIN = 120;
    /** A link or a command alone on its line cannot be broken. */
    private static final Pattern UNBREAKABLE = Pattern.compile("\\s*(?:!?\\[[^\\]]*]\\([^)]*\\)|`[^`]*`)\\p{Punct}?");

    static Stream<Path> documents() throws IOException {
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            List<Path> all = new ArrayList<>(
                    docs.filter(p -> p.toString().endsWith(".md")).sorted().toList());
            all.add(README);
            return all.stream();
        }
    }

    @ParameterizedTest
    @MethodSource("documents")
    void everyRelativeLinkLeadsToAFileAndAHeading(Path document) throws IOException {
        for (String link : linksOf(document)) {
            String[] parts = link.split("#", 2);
            Path target = parts[0].isEmpty()
                    ? document
                    : document.toAbsolutePath().getParent().resolve(parts[0]);
            assertThat(target).as("%s links to %s", document, link).exists();
            if (parts.length == 2) {
                assertThat(anchorsOf(target))
                        .as("%s links to %s", document, link)
                        .contains(parts[1]);
            }
        }
    }

    @Test
    void theMapOfDocumentsListsEveryPage() throws IOException {
        assertThat(linksOf(README)).contains("docs/README.md");
        List<Path> listed = linksOf(MAP).stream()
                .map(link -> MAP.resolveSibling(link).normalize())
                .toList();
        assertThat(documents().filter(d -> d.startsWith("docs") && !d.equals(MAP)))
                .isSubsetOf(listed);
    }

    @Test
    void noWrittenPageIsLong() throws IOException {
        for (Path document : documents().toList()) {
            if (!document.startsWith(RESULTS)) {
                assertThat(Files.readAllLines(document))
                        .as("%s, lines", document)
                        .hasSizeLessThanOrEqualTo(MOST_LINES);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("documents")
    void proseEndsAtTheMargin(Path document) throws IOException {
        if (document.startsWith(RESULTS) || document.equals(PARAMETERS)) {
            return;
        }
        assertThat(prose(document).lines())
                .as("%s, prose in columns", document)
                .filteredOn(line -> !line.startsWith("|") && !line.startsWith("#"))
                .allMatch(line ->
                        line.length() <= MARGIN || UNBREAKABLE.matcher(line).matches());
    }

    /** A row on one line, with as many cells as its heading. */
    @ParameterizedTest
    @MethodSource("documents")
    void rowsOfTablesHaveTheCellsOfTheirHeading(Path document) throws IOException {
        int cells = 0;
        for (String line : prose(document).lines().toList()) {
            int bars = line.replaceAll("\\\\\\|", "").replaceAll("[^|]", "").length();
            assertThat(line.startsWith("|")).as("%s: %s", document, line).isEqualTo(line.endsWith("|"));
            if (line.startsWith("|") && cells > 0) {
                assertThat(bars).as("%s: %s", document, line).isEqualTo(cells);
            }
            cells = line.startsWith("|") ? bars : 0;
        }
    }

    @Test
    void everyPageOfResultsStatesTheCommandAndTheCommitThatMadeIt() throws IOException {
        assertThat(documents().filter(document -> document.startsWith(RESULTS)))
                .isNotEmpty()
                .allSatisfy(document -> assertThat(Files.readString(document))
                        .contains("\n- With: phrenic ")
                        .containsPattern("\n- Commit [0-9a-f]{8}"));
    }

    @ParameterizedTest
    @MethodSource("documents")
    void everyMethodThatIsNamedIsThereToBeCalled(Path document) throws IOException {
        List<String> named = METHOD.matcher(Files.readString(document))
                .results()
                .map(match -> match.group(1))
                .distinct()
                .toList();
        assertThat(METHODS_OF_SOURCES).containsAll(named);
    }

    @BeforeAll
    static void readMethods() throws IOException {
        for (Path source : SourceTree.files()) {
            if (source.toString().endsWith(".java")) {
                DECLARED.matcher(Files.readString(source)).results().forEach(m -> METHODS_OF_SOURCES.add(m.group(1)));
            }
        }
    }

    @Test
    void theListOfDependenciesIsThatOfTheBuild() throws Exception {
        Map<String, String> listed = new TreeMap<>();
        ARTIFACT_ROW
                .matcher(Files.readString(Path.of("docs/dependencies.md")))
                .results()
                .forEach(row -> listed.put(row.group(1), row.group(2)));
        assertThat(listed).isEqualTo(artifactsOfTheBuild());
    }

    @Test
    void everyPackageIsIntroduced() throws IOException {
        assertThat(SourceTree.files().stream()
                        .filter(p -> p.toString().endsWith(".java"))
                        .filter(p -> p.toString().contains("src" + File.separator + "main"))
                        .map(Path::getParent)
                        .distinct())
                .isNotEmpty()
                .allSatisfy(folder ->
                        assertThat(folder.resolve("package-info.java")).exists());
    }

    private static List<String> linksOf(Path document) throws IOException {
        return LINK.matcher(prose(document))
                .results()
                .map(link -> link.group(1))
                .filter(link -> !link.contains("://") && !link.startsWith("mailto:"))
                .toList();
    }

    /** Anchors as GitHub makes them of headings: lower case, spaces to hyphens, other punctuation dropped. */
    private static List<String> anchorsOf(Path document) throws IOException {
        return HEADING.matcher(prose(document))
                .results()
                .map(heading -> heading.group(1)
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^\\p{L}\\p{N} _-]", "")
                        .replace(' ', '-'))
                .toList();
    }

    private static String prose(Path document) throws IOException {
        return FENCE.matcher(Files.readString(document)).replaceAll("");
    }

    /** {@code made_by} of a run and {@code machine} of a study are the version of the jar of their own module. */
    @Test
    void theJarOfEveryModuleStatesItsVersion() throws Exception {
        NodeList entries = pom().getElementsByTagName("addDefaultImplementationEntries");
        assertThat(entries.getLength()).isOne();
        assertThat(entries.item(0).getTextContent()).isEqualTo("true");
        assertThat(siblingText(entries.item(0).getParentNode().getParentNode().getParentNode(), "artifactId"))
                .isEqualTo("maven-jar-plugin");
    }

    private static Element pom() throws Exception {
        return DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(Path.of("pom.xml").toFile())
                .getDocumentElement();
    }

    /** Artifact and version of every dependency, plugin and annotation processor in pom.xml. */
    private static Map<String, String> artifactsOfTheBuild() throws Exception {
        Element pom = pom();
        Map<String, String> properties = new HashMap<>();
        NodeList declared = pom.getElementsByTagName("properties").item(0).getChildNodes();
        for (int i = 0; i < declared.getLength(); i++) {
            properties.put(
                    declared.item(i).getNodeName(),
                    declared.item(i).getTextContent().strip());
        }
        Map<String, String> artifacts = new TreeMap<>();
        NodeList found = pom.getElementsByTagName("artifactId");
        for (int i = 0; i < found.getLength(); i++) {
            String version = siblingText(found.item(i), "version");
            if (found.item(i).getParentNode() != pom
                    && version != null
                    && !"org.phrenic".equals(siblingText(found.item(i), "groupId"))) {
                MatchResult property =
                        PROPERTY.matcher(version).results().findFirst().orElse(null);
                artifacts.put(
                        found.item(i).getTextContent().strip(),
                        property == null ? version : properties.get(property.group(1)));
            }
        }
        return artifacts;
    }

    private static String siblingText(Node node, String name) {
        NodeList siblings = node.getParentNode().getChildNodes();
        for (int i = 0; i < siblings.getLength(); i++) {
            if (siblings.item(i).getNodeName().equals(name)) {
                return siblings.item(i).getTextContent().strip();
            }
        }
        return null;
    }
}
