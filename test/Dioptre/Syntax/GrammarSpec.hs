{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Syntax.GrammarSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Tree
import Laws.Text
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  describe "layout" $
    modifyMaxSuccess (const 300) $ do
      prop "takes comments and empty lines anywhere" $ \(SceneText t) -> ignoresComments t
      prop "takes blanks before a word" $ \(SceneText t) -> ignoresIndentation t
      prop "takes words in any case" $ \(SceneText t) -> ignoresCase t
      prop "takes a line end at the end, or none" $ \(SceneText t) -> endsWhereItEnds t

  describe "a line" $ do
    it "is a word and the rest, with their places" $
      tree [" \tposition\f [1, 2, 3]  "]
        `shouldBe` [Statement (Property (Head (Span 1 3 11) "position" (Just Keyword.Position)) (Value (Span 1 13 24) "[1, 2, 3]  "))]
    it "counts a tab and a letter beyond ASCII as one column" $
      tree ["\233t\233\t\128512 x"] `shouldBe` [Statement (Property (Head (Span 1 1 4) "\233t\233" Nothing) (Value (Span 1 5 8) "\128512 x"))]
    it "that has a property's word alone has an empty value, behind the word" $
      tree ["angle  "] `shouldBe` [Statement (Property (Head (Span 1 1 6) "angle" (Just Keyword.Angle)) (Value (Span 1 8 8) ""))]
    it "has blanks that are space, tab and form feed only" $
      map (said . pure) ["a\vb 1", "a\xA0\&b 1", "a\fb", "a\tb"] `shouldBe` [["a\vb=1"], ["a\xA0\&b=1"], ["a=b"], ["a=b"]]

  describe "an object" $ do
    it "is opened by its word, whatever follows it, and closed by an end, whatever follows it" $
      tree ["SPHERE # a", "FIN of it"]
        `shouldBe` [Object (Block (Head (Span 1 1 7) "SPHERE" (Just Keyword.Sphere)) (Value (Span 1 8 11) "# a") [] (ByEnd (Span 2 1 4)))]
    it "stands inside another" $
      said ["primitive", "geometry", "sphere", "ray 1", "end", "end", "material_name a", "end"]
        `shouldBe` ["primitive{", "geometry{", "sphere{", "ray=1", "}", "}", "material_name=a", "}"]
    it "is opened by an unknown word only where it is alone" $
      said ["foo ", "bar 1", "end", "foo 2", "end"] `shouldBe` ["foo{", "bar=1", "}", "foo=2", "!end"]
    it "is not opened by a known word that names a property" $
      said ["camera", "angle", "end"] `shouldBe` ["camera{", "angle=", "}"]
    it "is closed by a word that is nearly end, alone on its line" $ do
      said ["camera", "edn", "enf 1", "Ned"] `shouldBe` ["camera{", "}~edn", "enf=1", "!Ned"]
      for_ ["ende", "fi", "in", "fine", "emd", "FIM"] $ \w -> (w, said ["x", w]) `shouldBe` (w, ["x{", "}~" <> w])
      for_ ["dne", "nde1", "finie", "e", "n", "p"] $ \w -> (w, take 1 (drop 1 (said ["x", w]))) `shouldSatisfy` (/= (w, ["}~" <> w]))
    it "is closed by a word of the scene ahead, with all that is around it" $
      said ["x", "y", "z", "light 1", "Materiel 5", "end"] `shouldBe` ["x{", "y{", "z{", "light=1", "}Materiel", "}Materiel", "}Materiel", "Materiel{", "}"]
    it "is closed by the end of the file" $ said ["camera", "x", "angle 5"] `shouldBe` ["camera{", "x{", "angle=5", "}.", "}."]
    it "may have an end too many" $ said ["end", "camera", "end", "fin x"] `shouldBe` ["!end", "camera{", "}", "!fin"]

  describe "a comment" $ do
    it "is a line whose first word begins with one of six characters" $
      for_ ["# end", "/x", "//", "*x", "- camera", "!", "@camera", "\t # x", "/**", "/***/", "*/", "*/ end", "/*x", "-1"] $ \c -> (c, said [c, "angle 1"]) `shouldBe` (c, ["angle=1"])
    it "does not begin inside a line" $ said ["angle 1 # x", "ray #2"] `shouldBe` ["angle=1 # x", "ray=#2"]
    it "is one line that begins with the word /* and holds */" $
      for_ ["/* x */", "/* */", " /*\tx*/", "/* x */ camera", "/* a */ b */"] $ \c -> (c, said [c, "angle 1"]) `shouldBe` (c, ["angle=1"])
    it "is all lines from the word /* to the word */ that begins a line" $ do
      said ["/*", "camera", "x */", "/*", "*/x", "**/", "*/ end", "angle 1"] `shouldBe` ["angle=1"]
      said ["/* camera", "end", " \t*/", "angle 1"] `shouldBe` ["angle=1"]
      said ["/*", "*/"] `shouldBe` []
      said ["camera", "/*", "end", "*/", "angle 1", "end"] `shouldBe` ["camera{", "angle=1", "}"]
    it "does not nest" $ said ["/*", "/*", "*/", "angle 1", "*/", "ray 1"] `shouldBe` ["angle=1", "ray=1"]
    it "goes to the end of the file where it is never closed" $ do
      tree ["angle 1", "  /* x", "camera"] `shouldBe` tree ["angle 1"] <> [OpenComment (Span 2 3 5)]
      said ["camera", "/*", "end"] `shouldBe` ["camera{", "?", "}."]
      map (parse . fromText "a") ["/*", "/*\n", "/*\nx", "/* x"] `shouldBe` replicate 4 [OpenComment (Span 1 1 3)]

tree :: [Text] -> Tree
tree = parse . fromText "a" . Text.unlines

-- | The tree in short: @word{@ and @}@ around what stands in an object, @word=value@, and signs for what is odd.
said :: [Text] -> [Text]
said = concatMap short . tree
  where
    short node = case node of
      Object b -> (headText (blockHead b) <> "{") : concatMap short (blockNodes b) <> [closed (blockClosing b)]
      Statement p -> [headText (propertyHead p) <> "=" <> valueText (propertyValue p)]
      LooseEnd h -> ["!" <> headText h]
      OpenComment _ -> ["?"]
    closed c = case c of
      ByEnd _ -> "}"
      ByMisspeltEnd h -> "}~" <> headText h
      BySceneWord h -> "}" <> headText h
      ByEndOfFile -> "}."
