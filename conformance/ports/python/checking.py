"""From a tree to a scene and diagnostics (specification chapter 3). It cannot fail."""

import language as L
import tree
import values


class Item:
    """An object of a scene: its block, its values, and its shape if it has one (another Item)."""

    def __init__(self, block, found, shape=None):
        self.block, self.values, self.shape = block, found, shape
        self.places = {}               # name of a property -> (line, column) of its last value
                                       # that is not empty, taken or not (check.place),
        self.last = {}                 # and its last one, empty or not, as written


class Scene:
    """What is left of a text (check.total)."""

    def __init__(self):
        self.camera = Item(L.CAMERA, L.CAMERA.defaults())
        self.viewport = Item(L.VIEWPORT, L.VIEWPORT.defaults())
        self.raytracer = Item(L.RAYTRACER, L.RAYTRACER.defaults())
        self.models, self.primitives, self.materials, self.lights = [], [], [], []


SEVERITIES = {"decimal-comma": "warning", "missing-material": "warning",
              "repeated-material": "warning", "sampling-without-random": "warning",
              "no-model-file": "warning", "behind-opening": "warning",
              "no-material-name": "note", "replaced-object": "note"}


class Checker:
    def __init__(self):
        self.diagnostics = []
        self.scene = Scene()
        self.seen = set()              # camera, viewport, raytracer: a possible one was read

    def tell(self, code, line, column):
        self.diagnostics.append({"code": code, "severity": SEVERITIES.get(code, "error"),
                                 "line": line, "column": column})

    def tell_line(self, code, line):
        self.tell(code, line.number, line.column)

    # Reading an object (3.4)

    def file(self, children):
        """check.file-level, scene.order"""
        for child in children:
            if isinstance(child, tree.StrayEnd):
                self.tell_line("stray-end", child.line)
            elif isinstance(child, tree.UnclosedComment):
                self.tell_line("unclosed-comment", child.line)
            elif isinstance(child, tree.Object) and child.key in L.SCENE_BLOCKS:
                self.scene_object(child)
            else:
                self.unwanted(child)

    def unwanted(self, child):
        """code.unknown-word, code.misplaced-word, check.passed-over"""
        self.tell_line("misplaced-word" if child.key in L.WORDS else "unknown-word", child.line)

    def item(self, node, block):
        """An object, or None where it is impossible (object.impossible)."""
        if node.closed == "missing":
            self.tell_line("missing-end", node.line)
        elif node.closed is not None:
            self.tell_line("misspelt-end", node.closed)
        behind = values.TOKEN.search(node.line.value)      # code.behind-opening
        if behind and (behind.group().lower() in block.by_word
                       or node.key in L.SHAPES and values.is_number(behind.group())):
            self.tell("behind-opening", node.line.number, node.line.value_column + behind.start())
        item = Item(block, block.defaults())
        used = {}
        objects = False
        for child in node.children:
            if isinstance(child, tree.UnclosedComment):
                self.tell_line("unclosed-comment", child.line)
            elif isinstance(child, tree.Property):
                prop = block.by_word.get(child.key)
                if prop is None:
                    self.unwanted(child)
                else:
                    self.property(item, prop, child.line, used)
            elif block.has_shape and child.key in L.SHAPES:
                objects = True
                if item.shape is not None:                 # code.second-shape
                    self.tell_line("second-shape", child.line)
                else:                                      # object.shape
                    item.shape = self.item(child, L.SHAPES[child.key])
            else:
                objects = True
                self.unwanted(child)
        if block.has_shape and item.shape is None:         # code.no-shape
            if not objects:
                self.tell_line("no-shape", node.line)
            return None
        code = block.impossible(item.values)
        if code:
            self.tell_line(code, node.line)
            return None
        return item

    def property(self, item, prop, line, used):
        """object.defaults, object.several"""
        if line.value:                                     # check.place
            item.places[prop.name] = (line.number, line.value_column)
        item.last[prop.name] = line.value
        place = used.get(prop.name, 0)
        if prop.places > 1:
            if place >= prop.places:
                self.tell_line("repeated-property", line)
                return
            used[prop.name] = place + 1
        try:
            value = values.parse(prop, line)
            if prop.places > 1:
                ends = item.values[prop.name]
                if (place == 1 and item.block.impossible in (L.ends, L.lens)
                        and prop.name == "point" and value == ends[0]):   # code.same-point
                    raise values.Refused("same-point", line.value_column)
                ends[place] = value
            else:
                item.values[prop.name] = value
            if values.has_decimal_comma(prop, line):
                self.tell("decimal-comma", line.number, line.value_column)
        except values.Refused as refused:
            self.tell(refused.code, line.number, refused.column)

    def scene_object(self, node):
        """The objects of 3.5 and 3.6, and what is told of each when it has been read."""
        block = L.SCENE_BLOCKS[node.key]
        item = self.item(node, block)
        if item is None:
            return
        item.opening = (node.line.number, node.line.column)
        scene = self.scene
        if block.name in ("camera", "viewport", "raytracer"):
            if block.name in self.seen:                    # object.several-possible
                self.tell_line("replaced-object", node.line)
            self.seen.add(block.name)
            setattr(scene, block.name, item)
        elif block is L.PRIMITIVE:
            if "material_name" not in item.last:
                self.tell("no-material-name", *item.opening)
            scene.primitives.append(item)
        elif block in L.MATERIALS:
            if any(m.values["name"] == item.values["name"] for m in scene.materials):
                self.tell("repeated-material", *item.places.get("name", item.opening))
            scene.materials.append(item)
        elif block is L.MODEL:
            if "file" not in item.last:                  # code.no-model-file
                self.tell("no-model-file", *item.opening)
            elif item.last["file"] == "none":
                self.tell("no-model-file", *item.places["file"])
            scene.models.append(item)
        else:
            scene.lights.append(item)

    def finish(self):
        """scene.material.name, scene.material.substitute, code.missing-material,
        code.sampling-without-random, check.order"""
        tracer = self.scene.raytracer
        if tracer.values["sampling"] > 1 and tracer.values["pixel_coordinate"] != "random":
            self.tell("sampling-without-random", *tracer.places["sampling"])
        names = {m.values["name"] for m in self.scene.materials}
        for primitive in self.scene.primitives:
            name = primitive.values["material_name"]
            if name not in names:
                names.add(name)
                if "material_name" in primitive.places:
                    self.tell("missing-material", *primitive.places["material_name"])
                substitute = Item(L.MATERIAL, L.MATERIAL.defaults())
                substitute.values.update(name=name, kd=0.6, ks=0.7)
                self.scene.materials.append(substitute)
        self.diagnostics.sort(key=lambda d: (d["line"], d["column"]))


def check(text):
    """The scene of a text, and its diagnostics."""
    checker = Checker()
    checker.file(tree.read(text))
    checker.finish()
    return checker.scene, checker.diagnostics
