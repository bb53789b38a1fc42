{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Syntax.PrintSpec
  ( spec,
  )
where

import Data.Maybe (mapMaybe)
import qualified Data.Text as Text
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.Syntax.Keyword (Keyword, Role (..), role)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Value (..), propertyHead, propertyValue)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "an outline" $ do
    prop "reads back, words and values, without its remarks" $ \(AnOutline o) ->
      mapMaybe outlineOf (parse (fromText "a" (printOutline o))) === map withoutRemarks (filter (not . isRemark) o)
    prop "ends in a line end" $ \(AnOutline o) -> not (null o) ==> "\n" `Text.isSuffixOf` printOutline o
    it "of nothing is nothing" $ printOutline [] `shouldBe` ""
    it "is laid out as people do" $
      map Text.words (Text.lines (printOutline [Remark "Shapes", Group Keyword.Primitive [Line Keyword.MaterialName "a b", Group Keyword.Sphere [Line Keyword.Ray "2.0"]]]))
        `shouldBe` [["/*"], ["Shapes"], ["*/"], [], ["primitive"], ["material_name", "a", "b"], ["sphere"], ["ray", "2.0"], ["end", "#end", "sphere"], ["end", "#end", "primitive"], []]

  describe "deep outlines" $
    modifyMaxSuccess (const 1) $
      it "are printed to their end" $
        mapM_ (\depth -> length (Text.lines (printOutline [nested depth])) `shouldBe` 3 * depth + 1) [1 .. 60]
  where
    -- An object opens, has a line and closes; a scene's object is followed by an empty line.
    nested :: Int -> Outline
    nested depth = Group Keyword.Primitive (foldr (\_ inner -> [Line Keyword.Scale "[1.0, 1.0, 1.0]", Group Keyword.Geometry inner]) [Line Keyword.Ray "1.0"] [2 .. depth])

newtype AnOutline = AnOutline [Outline]
  deriving (Eq, Show)

instance Arbitrary AnOutline where
  arbitrary = AnOutline <$> resize 4 (listOf (oneof [remark, Group <$> elements (having OpensInScene) <*> resize 4 (listOf (inner (3 :: Int)))]))
    where
      remark = Remark <$> elements ["Shapes", "a b", "*", "end", "*/x"]
      inner depth
        | depth == 0 = Line <$> elements (having NamesProperty) <*> value
        | otherwise = oneof [inner 0, Group <$> elements (having OpensInside) <*> resize 3 (listOf (inner (depth - 1)))]
      value = elements ["1.0", "[1.0, 2.0]", "end", "# x", "/* x */", "a  ", "\233", "*/"]

having :: Role -> [Keyword]
having r = filter ((== r) . role) [minBound .. maxBound]

-- | What a tree says, places aside; nothing where it is no outline.
outlineOf :: Node -> Maybe Outline
outlineOf node = case node of
  Object b | ByEnd _ <- blockClosing b -> (`Group` mapMaybe outlineOf (blockNodes b)) <$> headKeyword (blockHead b)
  Statement p -> (`Line` valueText (propertyValue p)) <$> headKeyword (propertyHead p)
  _ -> Just (Remark "something odd")

isRemark :: Outline -> Bool
isRemark o = case o of
  Remark _ -> True
  _ -> False

withoutRemarks :: Outline -> Outline
withoutRemarks o = case o of
  Group k inner -> Group k (map withoutRemarks (filter (not . isRemark) inner))
  other -> other
